// How fast Jacobi's method gets rid of the products of inertia.
#include <support/record.hpp>
#include <tumble/principal_axes.hpp>

using namespace tumble;
using support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table =
      notebook.table("removed", {"removal", "the product", "from the two before"});
  const double product = 0.1;
  Mat3d I, axes = Mat3d::Identity();
  I << 1, product, -product,  //
      product, 1.8, 0,        //
      -product, 0, 2.6;
  const std::array<std::array<int, 2>, 3> planes = {{{0, 1}, {0, 2}, {1, 2}}};
  std::printf("removal   the product   the two before, by a difference\n");
  double before = 0, second_before = 0, gap_before = 1, gap_second_before = 1, removed = 0;
  for (std::size_t n = 0; n < 7; ++n) {
    const auto [p, q] = planes[n % 3];
    removed = std::abs(I(p, q));
    const double gap = I(q, q) - I(p, p);
    const double expected = n < 2 ? 0 : std::abs(before * second_before / gap_second_before);
    table.row(double(n + 1), removed, expected);
    if (n < 2)
      std::printf("%7zu       %.1e\n", n + 1, removed);
    else
      std::printf("%7zu       %.1e   %.1e\n", n + 1, removed, expected);
    second_before = before;
    before = removed;
    gap_second_before = gap_before;
    gap_before = gap;
    remove_product(I, axes, p, q);
  }
  support::expect(removed < 1e-12, "the seventh product is twelve powers of ten below 1");
  notebook.value("last", number("%.0e kg m²", removed));
}
