// What a damping that cannot be gets: a sentence, before anything moves.
#include <functional>
#include <support/damping_forms.hpp>
#include <support/record.hpp>
#include <tumble/damping.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int refused = 0;
  const auto attempt = [&refused](const std::function<double()>& action) {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      std::printf("%s\n", error.what());
      ++refused;
    }
  };
  attempt([] { return checked_damping_rate(-0.1); });
  attempt([nan] { return checked_damping_rate(nan, "angular damping of 'crate'"); });
  attempt([] { return damping_rate_that_leaves(99.0, 1.0); });
  attempt([] { return damping_rate_that_leaves(0.0, 1.0); });
  support::expect(refused == 4, "every one of the four is refused");
  const double power = support::power_form(-0.5, 1.0 / 60);
  std::printf("\nthe power form does not refuse: pow(-0.5, 1/60) is %s\n",
              std::isnan(power) ? "NaN" : "a number");
  support::expect(std::isnan(power), "a root of a negative number is NaN");
}
