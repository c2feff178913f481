// What a damping that cannot be gets: a sentence, before anything moves.
#include <support/damping_forms.hpp>
#include <support/refusals.hpp>
#include <tumble/damping.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  support::Table table = support::table_of_refusals(notebook, "bad_damping");
  int refused = 0;
  const auto rate = [&](const char* what, double value, const char* name) {
    refused += support::try_it(table, what, "checked_damping_rate",
                               [&] { checked_damping_rate(value, name); });
  };
  const auto fraction = [&](const char* what, double left) {
    refused += support::try_it(table, what, "damping_rate_that_leaves",
                               [&] { damping_rate_that_leaves(left, 1.0); });
  };
  rate("a rate below zero", -0.1, "damping rate");
  rate("a rate of 0/0", nan, "angular damping of 'crate'");
  fraction("a fraction of 99, meant as per cent", 99);
  fraction("a fraction of nothing", 0);
  support::expect(refused == 4, "every one of the four is refused");
  double power = 0;
  support::try_it(table, "a fraction of −0.5, in the power form", "power_form",
                  [&] { power = support::power_form(-0.5, 1.0 / 60); });
  support::expect(std::isnan(power), "a root of a negative number is NaN");
}
