// A body of 1000 particles against the integral over the solid that they are strewn in; and the
// same for more and more particles.
#include <support/particle_cloud.hpp>
#include <support/record.hpp>
#include <tumble/principal_axes.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

const Vec3d size(3, 2, 1);

/// Where a point in space is drawn.
Vec3d drawn(const Vec3d& r) {
  return {0.92 * r.x() + 0.4 * r.y(), 0, r.z() - 0.14 * r.x() + 0.3 * r.y()};
}

void draw_cloud(const Notebook& notebook, const std::vector<Particled>& particles,
                const MassPropertiesd& body) {
  Table table = notebook.table("cloud", {"kind", "x (m)", "z (m)", "dx (m)", "dz (m)", "text"});
  for (const Particled& particle : particles) {
    const Vec3d at = drawn(particle.position);
    table.row("particle", at.x(), at.z(), 0.0, 0.0, "");
  }
  const Vec3d half = size / 2;
  for (int i = 0; i < 3; ++i)
    for (const auto& [j, k] : {std::pair{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}) {
      Vec3d corner = -half;
      corner((i + 1) % 3) *= j;
      corner((i + 2) % 3) *= k;
      const Vec3d at = drawn(corner), edge = drawn(Vec3d::Unit(i) * size(i));
      table.row("edge", at.x(), at.z(), edge.x(), edge.z(), "");
    }
  const Vec3d centre = drawn(body.centre_of_mass);
  const auto [moments, axes] = principal_axes(body.inertia);
  for (int i = 0; i < 3; ++i) {
    const Vec3d axis = axes.col(i) * (axes.col(i).sum() < 0 ? -1 : 1);
    const Vec3d arrow = drawn(1.9 * axis);
    table.row("axis", centre.x(), centre.z(), arrow.x(), arrow.z(), "");
    const Vec3d label = centre + arrow + Vec3d(0.1, 0, 0.08);
    table.row("label", label.x(), label.z(), 0.0, 0.0, number("%.3f kg m²", moments(i)));
  }
  table.row("centre", centre.x(), centre.z(), 0.0, 0.0, "");
}

/// A rod from above that moves and turns: the velocities of five of its particles, in two parts.
void draw_velocities(const Notebook& notebook) {
  const Vec3d velocity(0.9, 0, 0), omega(0, 0, 0.8);
  const Vec3d apart = 0.6 * Vec3d(0.5, std::sqrt(0.75), 0), end = 2 * apart;
  Table table = notebook.table("velocities", {"kind", "x", "y", "dx", "dy"});
  table.row("rod", -end.x(), -end.y(), 2 * end.x(), 2 * end.y());
  for (int n = -2; n <= 2; ++n) {
    const Vec3d r = n * apart, turning = omega.cross(r);
    const auto row = [&](const char* kind, const Vec3d& from, const Vec3d& by) {
      table.row(kind, from.x(), from.y(), by.x(), by.y());
    };
    row("particle", r, Vec3d::Zero());
    row("moving", r, velocity);
    row("turning", r + velocity, turning);
    row("both", r, velocity + turning);
  }
}

void print_tensor(const char* title, const Mat3d& inertia) {
  std::printf("%s\n", title);
  for (int i = 0; i < 3; ++i)
    std::printf("  %8.4f %8.4f %8.4f\n", inertia(i, 0), inertia(i, 1), inertia(i, 2));
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  //! [thousand]
  const std::vector<Particled> particles = random_particles(size, 1000, 3);
  const MassPropertiesd cloud = mass_properties(particles);
  const MassPropertiesd solid = mass_properties(Box<double>{size}, 1);
  //! [thousand]
  draw_cloud(notebook, particles, cloud);
  draw_velocities(notebook);
  print_tensor("1000 random particles, 1 kg in all (kg m^2)", cloud.inertia);
  print_tensor("the integral over the box", solid.inertia);
  const double error = relative_error(cloud.inertia, solid.inertia);
  std::printf("relative difference  %.2f %%\n", 100 * error);
  notebook.value("error_1000", number("%.1f %%", 100 * error));

  Table table =
      notebook.table("sampling", {"particles", "random, RMS of 100 seeds", "fitted line"});
  Table rows = notebook.table("lattice", {"particles", "lattice"});
  const unsigned seeds = 100;
  std::vector<std::pair<double, double>> errors;
  for (int count = 16; count <= 65536; count *= 4) {
    double sum = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const double off = relative_error(
          mass_properties(random_particles(size, count, unsigned(count) * 1000 + seed)).inertia,
          solid.inertia);
      sum += off * off;
    }
    errors.emplace_back(count, std::sqrt(sum / seeds));
  }
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [count, rms] : errors) {
    x += std::log(count) / double(errors.size());
    y += std::log(rms) / double(errors.size());
  }
  for (const auto& [count, rms] : errors) {
    xx += (std::log(count) - x) * (std::log(count) - x);
    xy += (std::log(count) - x) * (std::log(rms) - y);
  }
  const double slope = xy / xx;
  for (const auto& [count, rms] : errors)
    table.row(count, rms, std::exp(y + slope * (std::log(count) - x)));
  for (const int n : {3, 4, 6, 10, 16, 25, 40})
    rows.row(double(n * n * n),
             relative_error(mass_properties(lattice_particles(size, n)).inertia, solid.inertia));
  std::printf("\n%d seeds for each count from 16 to 65536: the error falls with the power %.2f\n",
              int(seeds), slope);
  notebook.value("slope", number("%.2f", slope));
}
