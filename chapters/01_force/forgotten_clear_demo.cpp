// A mistake, run on purpose: the accumulator is never emptied, so every step pulls once more.
#include <support/record.hpp>
#include <tumble/force.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table =
      notebook.table("forgotten_clear", {"time (s)", "cleared (m)", "never cleared (m)"});
  const Vec3d gravity(0, 0, -9.81);
  const int steps_per_second = 60;
  Particled right = make_particle(1.0), wrong = make_particle(1.0);
  for (int n = 0; n <= steps_per_second; ++n) {
    table.row(double(n) / steps_per_second, right.position.z(), wrong.position.z());
    if (n == steps_per_second) break;
    for (Particled* ball : {&right, &wrong}) {
      add_gravity(*ball, gravity);
      step(*ball, 1.0 / steps_per_second);
    }
    clear_force(right);  // the line that the other one lacks
  }
  // After n steps the wrong one has been pulled 1 + 2 + ... + n times: its fall grows as t^3, h t^3
  // g / (6 h^2).
  const double ratio = wrong.position.z() / right.position.z();
  std::printf("after 1 s the cleared ball fell %.2f m, the other %.1f m: %.1f times as far\n",
              -right.position.z(), -wrong.position.z(), ratio);
  notebook.value("fell", support::number("%.2f m", -right.position.z()));
  notebook.value("ratio", support::number("%.1f", ratio));
  support::expect(std::abs(ratio - (steps_per_second + 2) / 3.0) < 1e-9,
                  "after n steps the fall is (n + 2)/3 times as far");
}
