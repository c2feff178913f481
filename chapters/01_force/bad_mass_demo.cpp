// What a mass that cannot be gets: a sentence, before anything moves.
#include <course/record.hpp>
#include <tumble/particle.hpp>

int main(int argument_count, char** arguments) {
  tumble::course::Notebook notebook(argument_count, arguments);
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
  tumble::course::expect(refused == 5, "every one of the five masses is refused");
}
