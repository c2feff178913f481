// A force that changes while a step lasts: what the step makes of it, and a head start that helps.
#include <support/record.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;

namespace {

/// The place after 2 s of a push of cos(t) newtons on 1 kg, which is 1 - cos(2) on paper.
double place(int steps_per_second, double head_start) {
  const double time_step = 1.0 / steps_per_second;
  Particled particle = make_particle(1.0);
  //! [changing]
  particle.velocity = Vec3d(head_start * time_step * std::cos(0.0), 0, 0);
  for (int n = 0; n < 2 * steps_per_second; ++n) {
    const double time = n * time_step;  // where the step begins
    clear_force(particle);
    add_force(particle, Vec3d(std::cos(time), 0, 0));
    step(particle, time_step);
  }
  //! [changing]
  return particle.position.x();
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double exact = 1 - std::cos(2.0);
  std::printf("steps per second   off by         a(0) h t / 2   off by, with half a kick back\n");
  for (const int rate : {15, 30, 60, 120}) {
    const double off = place(rate, 0) - exact, off_half = place(rate, -0.5) - exact;
    std::printf("%16d   %+.7f m   %+.7f m   %+.9f m\n", rate, off, 1.0 / rate, off_half);
    support::expect(std::abs(off_half) < 0.05 * off, "half a kick back takes most of the error");
  }
}
