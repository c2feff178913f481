// Three mistakes with a spinning top, run: what one sees of each.
#include <numbers>
#include <support/record.hpp>
#include <support/toy_gyroscope.hpp>

using namespace tumble;
using std::numbers::pi;
using support::number;

namespace {

const double degree = pi / 180, tilt = 60 * degree, spin = 200, seconds = 2;
const int steps_per_second = 240;

/// The largest tilt, degree, how fast the axis goes round, rad/s, and after how many seconds the
/// energy has grown a thousandfold, or 0.
struct Seen {
  double lowest = 0, round = 0, gone = 0;
};

template <class Turn>
Seen seen(const Gyroscope<double>& gyroscope, const Turn& turn) {
  Topd top = set_spinning(gyroscope, tilt, spin);
  const double energy = kinetic_energy(top), h = 1.0 / steps_per_second;
  Seen result;
  double turned = 0, before = 0;
  for (int n = 1; n <= seconds * steps_per_second; ++n) {
    turn(top, h);
    result.lowest = std::max(result.lowest, support::tilt_of(top) / degree);
    turned += std::remainder(support::azimuth_of(top) - before, 2 * pi);
    before = support::azimuth_of(top);
    result.round = turned / (n * h);
    if (kinetic_energy(top) < 1000 * energy) continue;
    result.gone = n * h;
    break;
  }
  return result;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const auto right = support::toy_gyroscope<double>();
  const auto step_right = [&](Topd& top, double h) { support::step(top, right, drift<double>, h); };

  //! [about_centre]
  auto about_centre = right;
  about_centre.across -= support::flywheel_mass * right.distance * right.distance;
  //! [about_centre]
  const auto step_about_centre = [&](Topd& top, double h) {
    support::step(top, about_centre, drift<double>, h);
  };

  //! [twice]
  const auto step_twice = [&](Topd& top, double h) {
    clear_torque(top);
    add_weight(top, right);
    add_torque(top, rotate(top.orientation, gyroscopic_torque(top)));  // drift() knows it already
    kick(top, h);
    drift(top, h);
  };
  //! [twice]

  //! [sign]
  const auto step_with_other_sign = [&](Topd& top, double h) {
    clear_torque(top);
    const Vec3d r = right.distance * axis_of(top), weight(0, 0, -right.weight);
    add_torque(top, weight.cross(r));  // r x F the wrong way round
    kick(top, h);
    drift(top, h);
  };
  //! [sign]

  std::printf("let go at 60 deg          sinks to   goes round at  stands by itself from\n");
  const auto show = [](const char* name, const Seen& of, const Gyroscope<double>& gyroscope) {
    if (of.gone > 0)
      std::printf("%-24s %6.1f deg, and is gone after %.2f s\n", name, of.lowest, of.gone);
    else
      std::printf("%-24s %6.1f deg %9.2f rad/s %9.0f rad/s\n", name, of.lowest, of.round,
                  least_sleeping_spin(gyroscope));
  };
  const Seen as_it_is = seen(right, step_right), centred = seen(about_centre, step_about_centre),
             twice = seen(right, step_twice), other = seen(right, step_with_other_sign);
  show("right", as_it_is, right);
  show("moment about the centre", centred, about_centre);
  show("the term twice", twice, right);
  show("the other sign", other, right);
  notebook.value("sleeps_about_centre", number("%.0f rad/s", least_sleeping_spin(about_centre)));
  notebook.value("sleeps", number("%.0f rad/s", least_sleeping_spin(right)));
  notebook.value("twice_gone", number("%.2f s", twice.gone));
  notebook.value("dip_about_centre", number("%.1f°", centred.lowest - 60));
  notebook.value("dip", number("%.1f°", as_it_is.lowest - 60));
  support::expect(std::abs(centred.round / as_it_is.round - 1) < 0.1 &&
                      centred.lowest - 60 < (as_it_is.lowest - 60) / 4,
                  "about the centre it goes round nearly as fast and hardly dips");
  support::expect(other.round < 0 && other.lowest < 61,
                  "with the other sign it rises and goes back");
  support::expect(twice.gone > 0, "with the term twice it flies apart");
}
