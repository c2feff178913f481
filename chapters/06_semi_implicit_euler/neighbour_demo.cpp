// What kick and drift keep of a pendulum and of a satellite: the energy plus half a step of the
// force's power, nearly.
#include <support/record.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using tumble::support::number;

namespace {

const double pi = 3.14159265358979323846;

/// A pendulum of 1 kg with ω = 1 rad/s; its angle is the place along x.
struct Pendulum {
  static Particled start() { return make_particle(1.0, Vec3d(2, 0, 0)); }
  static Vec3d force(const Vec3d& place) { return {-std::sin(place.x()), 0, 0}; }
  static double potential(const Vec3d& place) { return 1 - std::cos(place.x()); }
};

/// A satellite of 1 kg on an ellipse of eccentricity 0.5.
struct Satellite {
  static Particled start() {
    return make_particle(1.0, Vec3d(1, 0, 0), Vec3d(0, std::sqrt(1.5), 0));
  }
  static Vec3d force(const Vec3d& place) { return -place / std::pow(place.norm(), 3); }
  static double potential(const Vec3d& place) { return -1 / place.norm(); }
};

/// E + ½ h F·v; with a step of 0 the energy.
template <class Problem>
double nearby_energy(const Particled& body, double time_step) {
  return body.velocity.squaredNorm() / 2 + Problem::potential(body.position) +
         time_step / 2 * Problem::force(body.position).dot(body.velocity);
}

template <class Problem>
void advance(Particled& body, double time_step) {
  clear_force(body);
  add_force(body, Problem::force(body.position));
  step(body, time_step);
}

/// How far E, and E + ½ h F·v, get from their start within 100 seconds.
template <class Problem>
std::pair<double, double> wavering(double time_step) {
  Particled body = Problem::start();
  const double energy = nearby_energy<Problem>(body, 0),
               nearby = nearby_energy<Problem>(body, time_step);
  double energy_off = 0, nearby_off = 0;
  for (int n = 0; n < 100 / time_step; ++n) {
    advance<Problem>(body, time_step);
    energy_off = std::max(energy_off, std::abs(nearby_energy<Problem>(body, 0) - energy));
    nearby_off = std::max(nearby_off, std::abs(nearby_energy<Problem>(body, time_step) - nearby));
  }
  return {energy_off, nearby_off};
}

/// The curve through the pendulum's start on which its nearby energy is constant, seen from the
/// middle in each direction: outwards it rises.
void draw_curve(support::Table table, double time_step) {
  const double level = nearby_energy<Pendulum>(Pendulum::start(), time_step);
  for (int degree = 0; degree <= 360; degree += 3) {
    const double c = std::cos(degree * pi / 180), s = std::sin(degree * pi / 180);
    double inside = 0, outside = 3;
    for (int halving = 0; halving < 40; ++halving) {
      const double radius = (inside + outside) / 2;
      const Particled there = make_particle(1.0, Vec3d(radius * c, 0, 0), Vec3d(radius * s, 0, 0));
      (nearby_energy<Pendulum>(there, time_step) < level ? inside : outside) = radius;
    }
    table.row(inside * c, inside * s);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double long_step = 0.5;
  support::Table path = notebook.table("neighbour", {"angle (rad)", "rate (rad/s)"});
  Particled bob = Pendulum::start();
  for (int n = 0; n <= 27; ++n) {  // a swing and a half
    path.row(bob.position.x(), bob.velocity.x());
    advance<Pendulum>(bob, long_step);
  }
  draw_curve(notebook.table("neighbour_exact", {"angle (rad)", "rate (rad/s)"}), 0);
  draw_curve(notebook.table("neighbour_curve", {"angle (rad)", "rate (rad/s)"}), long_step);

  std::printf("             time step   E wavers by   E + hFv/2 wavers by\n");
  const auto show = [](const char* name, auto problem) {
    using Problem = decltype(problem);
    for (const double time_step : {0.04, 0.02, 0.01}) {
      const auto [energy, nearby] = wavering<Problem>(time_step);
      std::printf("%-10s %9.2f s %11.6f J %19.6f J\n", name, time_step, energy, nearby);
      const auto [half_energy, half_nearby] = wavering<Problem>(time_step / 2);
      support::expect(energy / half_energy > 1.9 && energy / half_energy < 2.1,
                      "half the step, half the wavering of E");
      support::expect(nearby / half_nearby > 3.7 && nearby / half_nearby < 4.3,
                      "and a quarter of that of E + hFv/2");
    }
  };
  show("pendulum", Pendulum());
  show("satellite", Satellite());
}
