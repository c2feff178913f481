/// @file
/// The sphere of L, live: a spin about any axis of a body, turned by any rule of chapter 8.
#pragma once

#include <support/live.hpp>
#include <support/polhodes.hpp>
#include <support/rules.hpp>

namespace tumble::support::energy_sphere {

using Column = std::vector<double>;

inline constexpr double gram = 1e-3, spin = 10, seconds = 12, degree = std::numbers::pi / 180;

/// What the knobs say at first.
struct Start {
  int rule = 6;
  double time_step = 1.0 / 60;  ///< s
  double wobble = 0.01;         ///< as a fraction of the spin
  int about = 1;                ///< the axis: 0 has the smallest moment, 2 the largest
};

/// A line on the sphere in three columns; no number ends it.
struct Curves {
  Column &x, &y, &z;

  Curves(support::Live& live, const std::string& name)
      : x(live.column(name + " x", "")),
        y(live.column(name + " y", "")),
        z(live.column(name + " z", "")) {}

  void add(const std::vector<Vec3d>& line, double sign = 1) {
    for (const Vec3d& point : line) push(sign * point);
    push(Vec3d::Constant(NAN));
  }
  void push(const Vec3d& point) {
    x.push_back(point.x());
    y.push_back(point.y());
    z.push_back(point.z());
  }
};

inline void draw_curves(support::Live& live, const Vec3d& inverse, const Vec3d& start) {
  Curves curves(live, "curve");
  for (const int around : {0, 2})
    for (const double off : {12.0, 26.0, 40.0}) {
      const auto [s, c] = sine_cosine(off * degree);
      const double level = inverse[around] * c * c + inverse[1] * s * s;
      const auto loop = support::polhode(inverse, level, around, 64);
      curves.add(loop);
      curves.add(loop, -1);
    }
  Curves border(live, "separatrix");
  for (const double sign : {1.0, -1.0}) border.add(support::separatrix(inverse, sign, 64));
  // The loop of this throw; none where L lies on an axis or on the border.
  Curves own(live, "own");
  const double level = dot(start, inverse.cwiseProduct(start));
  const int around = level > inverse[1] ? 0 : 2;
  if (level != inverse[1] && level != inverse[around])
    own.add(support::polhode(inverse, level, around, 128), start[around] < 0 ? -1 : 1);
}

inline void run(Live& live, const Start& first = {}) {
  const auto rule = static_cast<std::size_t>(live.choice("rule", first.rule, 7));
  const double h = live.knob("h", "s", first.time_step, 1.0 / 480, 0.25);
  const double wobble = live.knob("wobble", "", first.wobble, 1e-8, 1);
  const int about = live.choice("about", first.about, 3);
  const double middle = live.knob("middle", "g m²", 1.3, 1.02, 1.78);

  // Moments in ascending order. The top keeps its closest pair first; `axis` finds them again.
  const support::TumblingProblem thrown{.letter = ' ',
                                        .name = "thrown",
                                        .moments = {gram, middle * gram, 1.8 * gram},
                                        .angular_velocity = {},
                                        .seconds = 0,
                                        .seconds_to_angle = 0};
  Topd top = support::top_of<double>(thrown);
  std::array<int, 3> axis = {0, 1, 2};
  std::sort(axis.begin(), axis.end(),
            [&](int a, int b) { return top.inverse_moments[a] > top.inverse_moments[b]; });
  const auto in_order = [&axis](const Vec3d& v) {
    return Vec3d(v[axis[0]], v[axis[1]], v[axis[2]]);
  };
  Vec3d omega = Vec3d::Zero();
  omega[axis[static_cast<std::size_t>(about)]] = spin;
  omega[axis[about == 0 ? 1 : 0]] = wobble * spin;
  set_angular_velocity_body(top, omega);

  const Topd start = top;
  const double size = start.angular_momentum_body.norm(), energy = kinetic_energy(start);
  draw_curves(live, in_order(start.inverse_moments), in_order(start.angular_momentum_body) / size);
  const exact::FreeTop<double> exact(start);
  live.column("exact wait", "s").push_back(exact.period() / 2);

  Column &time = live.column("time", "s"), &energies = live.column("energy", "of E₀"),
         &momenta = live.column("momentum", "of |L₀|"), &flips = live.column("flips", "s");
  Curves tip(live, "tip"), L_world(live, "L"), omega_world(live, "omega");
  Column& real = live.column("q real", "");
  Curves imaginary(live, "q");
  Column& axes = live.column("axis", "");
  for (const int n : axis) axes.push_back(n);

  const int steps = static_cast<int>(seconds / h);
  double before = 0, widest = 0;  // since L_2 was last zero
  for (int n = 0; n <= steps; ++n) {
    const Vec3d L = in_order(top.angular_momentum_body) / size;
    const bool crosses = before * L[1] < 0;
    // A small loop around another axis is no flip.
    if (crosses && widest > 0.5) flips.push_back((n - L[1] / (L[1] - before)) * h);
    if (crosses) widest = 0;
    widest = std::max(widest, std::abs(L[1]) / L.norm());
    before = L[1];
    time.push_back(n * h);
    energies.push_back(kinetic_energy(top) / energy);
    momenta.push_back(L.norm());
    tip.push(L);
    L_world.push(angular_momentum_world(top) / size);
    omega_world.push(angular_velocity_world(top) / spin);
    real.push_back(top.orientation.real);
    imaginary.push(top.orientation.imaginary);
    support::rules<double>[rule].turn(top, h);
  }
}

}  // namespace tumble::support::energy_sphere
