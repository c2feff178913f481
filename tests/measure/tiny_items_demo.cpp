// tiny_items_demo [FOLDER]: sums in items of their own. Where TINY_ITEMS_BEGUN names a file, each
// that is begun leaves a line there and takes its time.
#include <chrono>
#include <support/items.hpp>
#include <thread>

using namespace tumble::support;

namespace {

std::string harmonic_sum(int terms) {
  if (const char* file = std::getenv("TINY_ITEMS_BEGUN")) {
    std::ofstream(file, std::ios::app) << terms << '\n';
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  double sum = 0;
  for (int n = 1; n <= terms; ++n) sum += 1.0 / n;
  expect(sum < 3, "a sum is less than three");
  return std::to_string(terms) + '\t' + number(sum) + '\n';
}

}  // namespace

int main(int argument_count, char** arguments) {
  const std::vector<int> counts = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 50, 100, 500};
  Items items;
  for (const int terms : counts)
    items.add("the first " + std::to_string(terms), [terms] { return harmonic_sum(terms); });
  if (!items.are_wanted()) return 0;

  Notebook notebook(argument_count, arguments);
  Table table = notebook.table("sums", {"terms", "sum"});
  for (const int terms : counts)
    for (const auto& row : cells_of(items.result("the first " + std::to_string(terms)))) {
      std::printf("%4s terms make %s\n", row.at(0).c_str(), row.at(1).c_str());
      table.row(row.at(0), row.at(1));
    }
  notebook.value("full", std::getenv("TUMBLE_FULL") ? "yes" : "no");
}
