// Poinsot's ellipsoid, live: the body moves as the ellipsoid of its energy rolls on a plane, whose
// distance the reader sets.
#include <support/live.hpp>
#include <support/polhodes.hpp>
#include <support/rules.hpp>

using namespace tumble;

namespace {

/// A vector in each row, in three columns.
struct Vectors {
  std::vector<double>&x, &y, &z;

  Vectors(support::Live& live, const std::string& name, const std::string& unit)
      : x(live.column(name + " x", unit)),
        y(live.column(name + " y", unit)),
        z(live.column(name + " z", unit)) {}

  void push(const Vec3d& vector) {
    x.push_back(vector.x());
    y.push_back(vector.y());
    z.push_back(vector.z());
  }
};

}  // namespace

void tumble::support::run_live(Live& live) {
  const double gram = 1e-3, spin = 10;
  const double height = live.knob("height", "rad/s", 8, 6, 9.95);
  const double middle = live.knob("middle", "g m²", 1, 0.92, 1.38);
  const Vec3d I(0.5 * gram, middle * gram, 1.4 * gram);

  // The energy is that of `spin` about axis 1, so that √(2E/I₁) is 10 rad/s, and 2E/|L| the height.
  // A spin without a part about axis 2 has any energy and |L| that the body can have together.
  const double twice_energy = I[0] * spin * spin, size = twice_energy / height;
  const double off = (size * size / I[0] - twice_energy) / (1 / I[0] - 1 / I[2]);  // L₃²
  const TumblingProblem problem{
      .letter = ' ',
      .name = "thrown",
      .moments = {I[0], I[1], I[2]},
      .angular_velocity = {std::sqrt(size * size - off) / I[0], 0, std::sqrt(off) / I[2]},
      .seconds = 0,
      .seconds_to_angle = 0};
  Topd top = top_of<double>(problem);
  // L points down, to a plane that is the floor: the turn from L to there about their normal.
  const Vec3d along = top.angular_momentum_body / size;
  top.orientation = normalized(Quaternion<double>{1 - along.z(), along.cross(Vec3d(0, 0, -1))});

  for (std::vector<double>& axes = live.column("semi-axes", "rad/s");
       const double inverse : top.inverse_moments)
    axes.push_back(std::sqrt(twice_energy * inverse));
  const auto [inner, outer] = herpolhode_radii(I, twice_energy, size * size);
  live.column("circles", "rad/s") = {inner, outer};

  std::vector<double>&time = live.column("time", "s"), &real = live.column("q real", "");
  Vectors imaginary(live, "q", ""), body(live, "body", "rad/s"), world(live, "world", "rad/s");
  const int per_second = 480, shown_per_second = 80, seconds = 12;
  for (int n = 0; n <= seconds * per_second; ++n) {
    if (n % (per_second / shown_per_second) == 0) {
      time.push_back(static_cast<double>(n) / per_second);
      real.push_back(top.orientation.real);
      imaginary.push(top.orientation.imaginary);
      body.push(angular_velocity_body(top));
      world.push(angular_velocity_world(top));
    }
    turn_by_splitting(top, 1.0 / per_second);
  }
}
