// A live figure as a program: NAME_live [VALUE,VALUE...] [DRAWN,DRAWN...] [TEXT=WORDS...] prints
// the knobs and all columns as JSON. Its numbers are the shortest that are read back as the same
// bits; what is none is null.
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <support/live.hpp>

namespace {

std::vector<double> state_of(const char* text) {
  std::vector<double> numbers;
  while (*text != '\0') {
    char* end = nullptr;
    numbers.push_back(std::strtod(text, &end));
    if (end == text) throw std::invalid_argument(std::string(text) + " is no number");
    text = *end == ',' ? end + 1 : end;
  }
  return numbers;
}

}  // namespace

int main(int argument_count, char** arguments) try {
  using namespace tumble;
  const auto given = [&](int n) {
    return n < argument_count ? state_of(arguments[n]) : std::vector<double>();
  };
  std::string written;
  for (int n = 3; n < argument_count; ++n) {
    const std::string argument = arguments[n];
    const std::size_t end = argument.find('=');
    if (end == std::string::npos) throw std::invalid_argument("a text reads NAME=WORDS");
    written += support::Live::as_written(argument.substr(0, end), argument.substr(end + 1));
  }
  support::Live live;
  do {
    live = support::Live(given(1), given(2), written);
    support::run_live(live);
  } while (live.goes_on());
  const auto with_values = [](std::string& json, const support::Live::Column& column) {
    json.append(",\"values\":[");
    for (const double& value : column.values)
      json.append(&value == column.values.data() ? "" : ",")
          .append(std::isfinite(value) ? text_of(value) : "null");
    json.append("]");
  };
  std::puts(support::as_json(live, with_values).c_str());
} catch (const std::exception& refusal) {
  std::fprintf(stderr, "%s\n", refusal.what());
  return EXIT_FAILURE;
}
