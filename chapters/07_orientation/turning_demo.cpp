// How far each rule turns a body in one step, against what was asked; and what the page's drawing
// of that step is drawn from.
#include <numbers>
#include <support/record.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using std::numbers::pi;

namespace {

/// The angle of a turn about z, from 0 to 2π.
double turned(const Quaterniond& q) {
  return 2 * std::atan2(q.imaginary.z(), q.real);
}

/// One step of 2 rad in the plane of the quaternion's real part and of its part along ω.
void draw_step(support::Notebook& notebook, const Vec3d& omega) {
  const double asked = 2;
  support::Table table = notebook.table(
      "off_the_circle", {"kind", "real", "along omega", "d real", "d along omega", "text"});
  const auto row = [&](const char* kind, const Quaterniond& from, const Quaterniond& by,
                       const char* text = "") {
    table.row(kind, from.real, from.imaginary.z(), by.real, by.imaginary.z(), text);
  };
  const Quaterniond none{}, nowhere{.real = 0};
  const Quaterniond step = asked * orientation_rate(none, omega), sum = none + step;
  const Quaterniond first = turn_first_order(none, omega, asked),
                    exponential = turn_exponential(none, omega, asked);
  for (int n = 0; n <= 100; ++n) row("circle", turn_exponential(none, omega, 0.035 * n), nowhere);
  for (int n = 0; n <= 100; ++n)
    row("arc", turn_exponential(none, omega, 0.01 * asked * n), nowhere);
  row("step", none, step);
  row("back", nowhere, sum);
  row("sum name", sum, nowhere);
  row("first", first, nowhere, "first order");
  row("exponential", exponential, nowhere, "exponential");
  notebook.value("half_asked", support::number("%g", step.imaginary.norm()));
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Vec3d omega(0, 0, 1);

  std::printf("asked: omega h   first order   of what was asked   exponential\n");
  for (const double turn : {0.01, 0.1, 0.5, 1.0, 2.0, 3.0, 6.0}) {
    const double first = turned(turn_first_order<double>({}, omega, turn)),
                 exponential = turned(turn_exponential<double>({}, omega, turn));
    std::printf("%10.2f rad   %7.4f rad   %17.4f   %7.4f rad\n", turn, first, first / turn,
                exponential);
    support::expect(std::abs(first - 2 * std::atan(turn / 2)) < 1e-14, "2 atan(omega h / 2)");
    support::expect(std::abs(exponential - turn) < 1e-14, "omega h");
  }
  support::Table table = notebook.table(
      "angle_per_step", {"omega h (rad)", "first order (rad)", "exponential (rad)", "half a turn"});
  for (int n = 0; n < 63; ++n) {
    const double turn = 0.1 * n;
    table.row(turn, turned(turn_first_order<double>({}, omega, turn)),
              turned(turn_exponential<double>({}, omega, turn)), pi);
  }

  draw_step(notebook, omega);

  std::printf("\na wheel, 60 steps a second, first order: after 10 s it is behind by\n");
  for (const double turns_per_second : {0.1, 1.0, 5.0}) {
    Quaterniond exact, first;
    double behind = 0;  // summed step by step, since one turn looks like none
    for (int n = 0; n < 600; ++n) {
      const double angle_before = turned(conjugate(first) * exact);
      exact = turn_exponential(exact, Vec3d(0, 0, 2 * pi * turns_per_second), 1.0 / 60);
      first = turn_first_order(first, Vec3d(0, 0, 2 * pi * turns_per_second), 1.0 / 60);
      behind += std::remainder(turned(conjugate(first) * exact) - angle_before, 2 * pi);
    }
    const std::string degrees = support::number("%.3g", behind * 180 / pi);
    std::printf("  %8s degrees at %g turns a second\n", degrees.c_str(), turns_per_second);
    if (turns_per_second == 0.1) notebook.value("behind_slow", degrees);
    if (turns_per_second == 5.0)
      notebook.value("behind_fast", support::number("%.1f", behind / (2 * pi)));
  }
}
