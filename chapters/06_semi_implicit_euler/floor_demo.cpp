// A ball lies on the floor: an impulse stops it in every step. Where in the step?
#include <support/record.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;

namespace {

const Vec3d weight(0, 0, -9.81);  // of 1 kg
const double time_step = 1.0 / 60;

/// The impulse of a floor that stops whatever moves downward.
Vec3d floor_impulse(const Particled& ball) {
  return {0, 0, std::max(0.0, -ball.velocity.z()) / ball.inverse_mass};
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  Particled before = make_particle(1.0), between = before, after = before;
  for (int n = 0; n < 600; ++n) {
    for (Particled* ball : {&before, &between, &after}) {
      clear_force(*ball);
      add_force(*ball, weight);
    }
    apply_impulse(before, floor_impulse(before));
    step(before, time_step);

    //! [between]
    kick(between, time_step);
    apply_impulse(between, floor_impulse(between));
    drift(between, time_step);
    //! [between]

    step(after, time_step);
    apply_impulse(after, floor_impulse(after));
  }
  std::printf("after 10 s on the floor, with the impulse\n");
  std::printf("before the kick:              %7.3f m\n", before.position.z());
  std::printf("between kick and drift:       %7.3f m\n", between.position.z());
  std::printf("after the drift:              %7.3f m\n", after.position.z());
  notebook.value("sunk", support::number("%.2f m", -before.position.z()));
  support::expect(between.position.z() == 0, "between kick and drift the ball stays where it is");
  const double sunk = 9.81 * time_step * time_step * 600;
  support::expect(std::abs(before.position.z() + sunk) < 1e-9,
                  "before it, it sinks by g h h a step");
  support::expect(std::abs(after.position.z() + sunk) < 1e-9, "after it, it sinks as fast");
}
