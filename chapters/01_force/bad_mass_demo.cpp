// What a mass that cannot be gets: a sentence, before anything moves.
#include <support/record.hpp>
#include <tumble/particle.hpp>

int main(int argument_count, char** arguments) {
  tumble::support::Notebook notebook(argument_count, arguments);
  int refused = 0;
  using Limits = std::numeric_limits<float>;
  for (const float mass : {0.0f, -2.0f, Limits::quiet_NaN(), Limits::infinity(), 1e-41f}) {
    try {
      tumble::make_particle(mass);
    } catch (const std::invalid_argument& error) {
      std::printf("%s\n", error.what());
      ++refused;
    }
  }
  tumble::support::expect(refused == 5, "every one of the five masses is refused");
  // Below the normal numbers a digit is lost with every halving; the smallest of all has one left.
  notebook.value("digits_left",
                 std::to_string(std::ilogb(1e-41f) - std::ilogb(Limits::denorm_min()) + 1));
  notebook.value("digits", std::to_string(Limits::digits));
}
