/// @file
/// The yardstick: a whole step of a whole scene in one loop over plain arrays, written for speed
/// alone. It plans nothing, checks nothing, and knows one scene at a time.
#pragma once

#include <cmath>
#include <support/bench/columns.hpp>
#include <support/bench/shares.hpp>
#include <tumble/sine_cosine.hpp>

namespace tumble::support::bench {

/// By which rule the loop turns its bodies.
enum class Rule {
  splitting,      ///< that of chapter 8
  cayley,         ///< the same, each turn by 2 atan(θ/2) instead of θ: no sine, as stable
  explicit_euler  ///< L ← L + h L × ω and q + h ½ q ω: the least that engines do; it blows up
};

/// What is the same for all bodies, computed once.
template <class Real>
struct Constants {
  Real time_step, gravity_step, fraction_kept;
  explicit Constants(double h)
      : time_step(static_cast<Real>(h)),
        gravity_step(static_cast<Real>(h * gravity)),
        fraction_kept(static_cast<Real>(std::exp(-damping_rate * h))) {}
};

/// Three numbers of a body.
template <class Real>
struct Three {
  Real x, y, z;
  Real square() const { return x * x + y * y + z * z; }
};

/// A top's numbers while the loop works on it. Each has a name of its own: an array inside the loop
/// would keep the compiler from taking several bodies at once.
template <class Real>
struct PlainTop {
  Real w, x, y, z;                // orientation
  Three<Real> momentum, inverse;  // body axes

  /// The orientation times w2 + (x2, y2, z2).
  void then(Real w2, Real x2, Real y2, Real z2) {
    const Real w1 = w, x1 = x, y1 = y, z1 = z;
    w = w1 * w2 - (x1 * x2 + y1 * y2 + z1 * z2);
    x = w1 * x2 + w2 * x1 + (y1 * z2 - z1 * y2);
    y = w1 * y2 + w2 * y1 + (z1 * x2 - x1 * z2);
    z = w1 * z2 + w2 * z1 + (x1 * y2 - y1 * x2);
  }

  void normalize() {
    const Real factor = 1 / std::sqrt(w * w + x * x + y * y + z * z);
    w *= factor, x *= factor, y *= factor, z *= factor;
  }

  /// Turns by twice `half` (rad) about a body axis. Then come the momentum's components along the
  /// next two axes, and the orientation's along this axis and those.
  template <Rule rule>
  void turn_about(Real half, Real& a, Real& b, Real& along, Real& next, Real& last) {
    Real c = 1, s = half;  // cosine and sine of the half angle, or in this ratio
    Real sine, one_minus_cosine;
    if constexpr (rule == Rule::cayley) {
      const Real scale = 2 / (1 + half * half);
      sine = scale * half, one_minus_cosine = sine * half;
    } else {
      const SineCosine<Real> turn = sine_cosine(half);
      c = turn.cosine, s = turn.sine;
      sine = 2 * s * c, one_minus_cosine = 2 * s * s;
    }
    const Real a1 = a, b1 = b, w1 = w, along1 = along, next1 = next, last1 = last;
    a = a1 + (sine * b1 - one_minus_cosine * a1);
    b = b1 - (sine * a1 + one_minus_cosine * b1);
    w = c * w1 - s * along1;
    along = c * along1 + s * w1;
    next = c * next1 + s * last1;
    last = c * last1 - s * next1;
  }

  template <Rule rule>
  void turn_freely(Real h) {
    Three<Real>& L = momentum;
    const Real about_y = h / 4 * (inverse.y - inverse.x), about_z = h / 2 * (inverse.z - inverse.x);
    const Real square_before = L.square();
    turn_about<rule>(about_y * L.y, L.z, L.x, y, z, x);
    turn_about<rule>(about_z * L.z, L.x, L.y, z, x, y);
    turn_about<rule>(about_y * L.y, L.z, L.x, y, z, x);
    const Real square = L.square();
    const Real correction = (square_before - square) / (2 * square);
    const Real kept = square > 0 ? correction : Real(0);
    L.x += kept * L.x, L.y += kept * L.y, L.z += kept * L.z;
    const Real half = h / 2 * inverse.x;
    if constexpr (rule == Rule::cayley) {
      then(1, half * L.x, half * L.y, half * L.z);
    } else {
      const Real angle = half * std::sqrt(L.square());
      const SineCosine<Real> turn = sine_cosine(angle);
      const Real factor = half * sine_over_angle(turn.sine, angle);
      then(turn.cosine, factor * L.x, factor * L.y, factor * L.z);
    }
    normalize();
  }

  void turn_explicitly(Real h) {
    const Three<Real> L = momentum;
    const Real p = inverse.x * L.x, q = inverse.y * L.y, r = inverse.z * L.z;
    momentum.x += h * (L.y * r - L.z * q);
    momentum.y += h * (L.z * p - L.x * r);
    momentum.z += h * (L.x * q - L.y * p);
    then(1, h / 2 * inverse.x * momentum.x, h / 2 * inverse.y * momentum.y,
         h / 2 * inverse.z * momentum.z);
    normalize();
  }

  /// Adds a blow that is given in world axes: q* v q of it.
  void kick(Real i, Real j, Real k) {
    const Real a = 2 * (z * j - y * k), b = 2 * (x * k - z * i), c = 2 * (y * i - x * j);
    momentum.x += i + w * a + (z * b - y * c);
    momentum.y += j + w * b + (x * c - z * a);
    momentum.z += k + w * c + (y * a - x * b);
  }
};

/// One step of the bodies from `first` up to `end`. No column overlaps another, which the line
/// above the loop promises to the compiler; and all that is called must be taken into the loop.
template <class Real, Scene scene, Rule rule>
[[gnu::flatten]] void step_plainly(const Columns<Real>& columns, std::size_t first, std::size_t end,
                                   const Constants<Real>& constants) {
  const Constants<Real> k = constants;
  const Real h = k.time_step;
  Real *const px = columns.column(position_x), *const py = columns.column(position_y),
              *const pz = columns.column(position_z), *const vx = columns.column(velocity_x),
              *const vy = columns.column(velocity_y), *const vz = columns.column(velocity_z),
              *const qw = columns.column(orientation_real),
              *const qx = columns.column(orientation_x), *const qy = columns.column(orientation_y),
              *const qz = columns.column(orientation_z), *const lx = columns.column(momentum_x),
              *const ly = columns.column(momentum_y), *const lz = columns.column(momentum_z),
              *const tx = columns.column(torque_x), *const ty = columns.column(torque_y),
              *const tz = columns.column(torque_z), *const ix = columns.column(inverse_moment_x),
              *const iy = columns.column(inverse_moment_y),
              *const iz = columns.column(inverse_moment_z);
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
  for (std::size_t n = first; n < end; ++n) {
    const Real kept = has_damping(scene) ? k.fraction_kept : Real(1);
    Real u = vx[n], v = vy[n], w = vz[n];
    if constexpr (has_gravity(scene)) w += k.gravity_step;
    if constexpr (has_damping(scene)) u *= kept, v *= kept, w *= kept;
    if constexpr (has_damping(scene)) vx[n] = u, vy[n] = v;
    if constexpr (has_damping(scene) || has_gravity(scene)) vz[n] = w;
    px[n] += h * u, py[n] += h * v, pz[n] += h * w;
    if constexpr (has_tops(scene)) {
      PlainTop<Real> top = {
          qw[n], qx[n], qy[n], qz[n], {lx[n], ly[n], lz[n]}, {ix[n], iy[n], iz[n]}};
      if constexpr (has_torque(scene)) top.kick(h * tx[n], h * ty[n], h * tz[n]);
      if constexpr (has_damping(scene))
        top.momentum.x *= kept, top.momentum.y *= kept, top.momentum.z *= kept;
      if constexpr (rule == Rule::explicit_euler)
        top.turn_explicitly(h);
      else
        top.template turn_freely<rule>(h);
      qw[n] = top.w, qx[n] = top.x, qy[n] = top.y, qz[n] = top.z;
      lx[n] = top.momentum.x, ly[n] = top.momentum.y, lz[n] = top.momentum.z;
    }
  }
}

/// Bodies that the plain loop steps.
template <class Real, Scene scene, Rule rule>
class PlainBodies {
 public:
  explicit PlainBodies(const Setting& setting, Spacing spacing = Spacing::padded)
      : columns_(setting.count, spacing),
        constants_(setting.time_step()),
        threads_(setting.threads) {}

  /// Each thread takes its share of the bodies through all steps: they have nothing to do with one
  /// another.
  void run(int steps) {
    in_shares(columns_.count(), threads_, [&](std::size_t first, std::size_t end) {
      for (int step = 0; step < steps; ++step)
        step_plainly<Real, scene, rule>(columns_, first, end, constants_);
    });
  }

  Motion motion(std::size_t n) const { return columns_.motion(n); }

 private:
  Columns<Real> columns_;
  Constants<Real> constants_;
  int threads_;
};

/// The bytes that a step of one body must read and write, whoever steps it: position and velocity,
/// orientation and momentum both ways; torque and inverse moments one way.
template <class Real>
constexpr double bytes_of_step(Scene scene) {
  int numbers = 6 + (has_gravity(scene) || has_damping(scene) ? 6 : 3);
  if (has_tops(scene)) numbers += 2 * 7 + 3 + (has_torque(scene) ? 3 : 0);
  return numbers * static_cast<double>(sizeof(Real));
}

}  // namespace tumble::support::bench
