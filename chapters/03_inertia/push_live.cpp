// A hammer on ice, live: one push, somewhere on it, seen from above.
#include <support/live.hpp>
#include <tumble/force.hpp>
#include <tumble/mass_properties.hpp>
#include <tumble/sine_cosine.hpp>
#include <tumble/solids.hpp>
#include <tumble/torque.hpp>

using namespace tumble;

void tumble::support::run_live(Live& live) {
  const double at = live.knob("at", "m", -0.15, -0.15, 0.18);
  const double impulse = live.knob("impulse", "N s", 0.5, 0.05, 1);
  const double angle = live.knob("angle", "°", 0, -180, 180) * std::numbers::pi / 180;
  const double head = live.knob("head", "kg", 0.5, 0, 2);

  // A handle along y, 30 cm of ash, and a head across its end.
  const double handle_mass = 0.15;
  MassProperties<double> hammer =
      mass_properties(Box<double>{.size = {0.03, 0.3, 0.03}}, handle_mass);
  if (head > 0) {
    MassProperties<double> block = mass_properties(Box<double>{.size = {0.1, 0.03, 0.03}}, head);
    block.centre_of_mass.y() = 0.165;
    hammer = combined<double>({hammer, block});
  }
  const double centre = hammer.centre_of_mass.y(), moment = hammer.inertia(2, 2);

  // The push lasts for one step of a thousandth of a second; then nothing acts.
  const double h = 1e-3;
  const auto [sine, cosine] = sine_cosine(angle);
  const Vec3d force = impulse / h * Vec3d(cosine, sine, 0);
  const Vec3d point(0, at, 0);
  Particled middle = make_particle(hammer.mass, hammer.centre_of_mass);
  add_force(middle, force);
  const double spin = h * torque_about(middle.position, point, force).z() / moment;  // rad/s
  kick(middle, h);
  clear_force(middle);

  // The point on the handle's line that stands still for this instant: v_x − ω (y − centre) = 0.
  live.column("centre", "m").push_back(centre);
  live.column("moment", "kg m²").push_back(moment);
  live.column("spin", "rad/s").push_back(spin);
  live.column("at rest", "m").push_back(spin != 0 ? centre + middle.velocity.x() / spin : NAN);
  live.column("speed", "m/s").push_back(middle.velocity.norm());

  std::vector<double>&time = live.column("time", "s"), &x = live.column("x", "m"),
  &y = live.column("y", "m"), &c = live.column("cosine", ""), &s = live.column("sine", "");
  for (int n = 0; n <= 250; ++n) {
    const double t = n * 0.004;
    const auto turned = sine_cosine(spin * t);
    time.push_back(t);
    x.push_back(middle.position.x());
    y.push_back(middle.position.y());
    c.push_back(turned.cosine);
    s.push_back(turned.sine);
    for (int part = 0; part < 4; ++part) drift(middle, h);
  }
}
