// Sums over particles become an integral: how fast.
#include <support/checks.hpp>
#include <support/particle_cloud.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE("The error of random particles falls as one over the root of their number") {
  const Vec3d size(3, 2, 1);
  const Mat3d truth = mass_properties(Box<double>{size}, 1).inertia;
  const int seeds = 100;
  std::vector<double> x, y;  // logarithms of the count and of the RMS error
  for (const int count : {64, 256, 1024, 4096, 16384}) {
    double sum = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const auto particles = random_particles(size, count, 1000u * unsigned(count) + seed);
      const double error = relative_error(mass_properties(particles).inertia, truth);
      sum += error * error;
    }
    x.push_back(std::log(count));
    y.push_back(std::log(sum / seeds) / 2);
  }
  const double points = double(x.size());
  double x_mean = 0, xx = 0, xy = 0;
  for (const double xi : x) x_mean += xi / points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * y[i];
  }
  // The mean of 100 squared errors is itself uncertain by at most sqrt(2/100) of itself, its root's
  // logarithm by half of that; the slope of a fitted line then by that over sqrt(xx). Five times
  // this is passed by chance less than once in a million.
  const double uncertainty = std::sqrt(2.0 / seeds) / 2 / std::sqrt(xx);
  CHECK(std::abs(xy / xx + 0.5) <= 5 * uncertainty);
}

TEST_CASE_TEMPLATE("A lattice of n by n by n particles falls short of the box by exactly 1/n²",
                   Real, EVERY_PRECISION) {
  // The mean of ((i + ½)/n − ½)² over i = 0 … n−1 is (1 − 1/n²)/12.
  const Vec3<Real> size(3, 2, 1);
  const Mat3<Real> truth = mass_properties(Box<Real>{size}, 1).inertia;
  for (const int n : {1, 2, 5, 12}) {
    CAPTURE(n);
    const Mat3<Real> lattice = mass_properties(lattice_particles(size, n)).inertia;
    const Real shortfall = 1 / Real(n * n);
    // A position is off by 4 roundings of half its range, the compensated sums by a few more.
    CHECK((lattice - truth * (1 - shortfall)).norm() <= 20 * unit_roundoff<Real> * truth.norm());
  }
}

TEST_CASE("A sum of a million particles in float rounds no more than a sum of two") {
  std::vector<Particle<float>> particles;
  std::vector<Particle<double>> witness;
  for (const Particle<float>& particle : random_particles(Vec3f(3, 2, 1), 1'000'000, 7)) {
    particles.push_back(particle);
    witness.push_back({.position = particle.position.cast<double>(), .inverse_mass = 1e6});
  }
  const Mat3d truth = mass_properties(witness).inertia;
  // Some 8 roundings a term, 2 for the whole sum, and those of 1/1000000 and of the centre.
  const MassProperties<float> body = mass_properties(particles);
  CHECK(relative_error<double>(body.inertia.cast<double>(), truth) <=
        16 * double(unit_roundoff<float>));
  // And so do the mass and the centre, seen from the first particle, in a box 3 m long.
  CHECK(std::abs(double(body.mass) / mass_properties(witness).mass - 1) <=
        4 * double(unit_roundoff<float>));
  CHECK(distance(Vec3d(body.centre_of_mass.cast<double>()),
                 mass_properties(witness).centre_of_mass) <= 3 * 16 * double(unit_roundoff<float>));
}
