// A satellite on an ellipse, stepped in both orders. Lengths in units of the smallest distance.
#include <support/record.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using tumble::support::number;

namespace {

const double pi = 3.14159265358979323846;
const double eccentricity = 0.5;

void gather_pull(Particled& satellite) {
  const double distance = satellite.position.norm();
  clear_force(satellite);
  add_force(satellite, -satellite.position / (distance * distance * distance));
}

double energy(const Particled& satellite) {
  return satellite.velocity.squaredNorm() / 2 - 1 / satellite.position.norm();
}

double angular_momentum(const Particled& satellite) {
  return satellite.position.cross(satellite.velocity).z();
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double half_axis = 1 / (1 - eccentricity);
  const double round_trip = 2 * pi * std::pow(half_axis, 1.5);
  const int steps_per_orbit = 240;
  const double time_step = round_trip / steps_per_orbit;

  support::Table exact = notebook.table("exact_orbit", {"x", "y"});
  for (int degree = 0; degree <= 360; degree += 2) {
    const double angle = degree * pi / 180;
    const double distance =
        (1 - eccentricity * eccentricity) * half_axis / (1 + eccentricity * std::cos(angle));
    exact.row(distance * std::cos(angle), distance * std::sin(angle));
  }

  Particled semi = make_particle(1.0, Vec3d(1, 0, 0), Vec3d(0, std::sqrt(1 + eccentricity), 0));
  Particled explicitly = semi;
  support::Table path = notebook.table(
      "orbit", {"orbits", "explicit x", "explicit y", "semi-implicit x", "semi-implicit y"});
  std::printf("            explicit Euler               kick, then drift\n");
  std::printf("orbits      energy   angular momentum    energy   angular momentum\n");
  double semi_momentum_off = 0;
  const double start_momentum = angular_momentum(semi);
  for (int n = 0; n <= 100 * steps_per_orbit; ++n) {
    const int orbits = n / steps_per_orbit;
    if (n <= 3 * steps_per_orbit)
      path.row(double(n) / steps_per_orbit, explicitly.position.x(), explicitly.position.y(),
               semi.position.x(), semi.position.y());
    if (n % steps_per_orbit == 0 && (orbits == 0 || orbits == 1 || orbits == 10 || orbits == 100))
      std::printf("%6d %11.4f %18.4f %9.4f %18.4f\n", orbits, energy(explicitly),
                  angular_momentum(explicitly), energy(semi), angular_momentum(semi));
    semi_momentum_off =
        std::max(semi_momentum_off, std::abs(angular_momentum(semi) / start_momentum - 1));
    gather_pull(semi);
    step(semi, time_step);
    gather_pull(explicitly);
    explicit_step(explicitly, time_step);
  }
  notebook.value("momentum_off", number("%.0e", semi_momentum_off));
  support::expect(semi_momentum_off < 1e-12, "kick and drift keep the angular momentum");
  support::expect(angular_momentum(explicitly) > 1.2 * start_momentum,
                  "explicit Euler's angular momentum grows");
}
