/// @file
/// The exact motion of a top without torque, with its orientation: body axes against world axes at
/// any time, without a step in between.
///
/// L stands still in the world and Euler's equations say how it moves in the body:
/// L₁' = L₂ L₃ (1/I₃ − 1/I₂), and so on around. Energy and |L| are constant, so the tip of L runs
/// along the line where a sphere and an ellipsoid meet, and goes around one of the two outer axes.
/// Call that axis z, the other outer axis x, the middle one y, with a sign of y that makes the
/// three right-handed. With i = 1/I and D_k = |L|² i_k − 2E (Landau and Lifshitz, Mechanics, §37):
///
///     L_x = A cn u,  L_y = B sn u,  L_z = C dn u,  u = λ t + u₀,
///     A² = −D_z/(i_x − i_z),  B² = −D_z/(i_y − i_z),  C² = D_x/(i_x − i_z),  λ² = (i_y − i_z) D_x,
///     m = (i_x − i_y)(−D_z)/λ²,  1 − m = (i_x − i_z) D_y/λ².
///
/// z is the axis for which D_y has the sign of D_x. Written with differences of inverse moments,
/// nothing is lost where two moments are nearly equal or a million times as large as the third.
///
/// The z axis goes around L at the rate |L| (L_x² i_x + L_y² i_y)/(L_x² + L_y²). Its integral is
/// one of the third kind; the form with its parameter n in m … 1 (Abramowitz and Stegun 17.7) has
/// an arc tangent for whatever is quick and a slow rest:
///
///     φ = 2E t/|L| + D_y/(λ|L|) (Π(n; u) − Π(n; u₀)) ± (atan w(u) − atan w(u₀)),
///     n = (i_x − i_y)|L|²/D_x,  w = |i_x − i_y| |L|/λ · sn cn/dn,  + where i_x > i_z.
///
/// φ, the angle θ from L to z, and the angle at which L is seen around z are Euler's three angles.
#pragma once

#include <algorithm>
#include <array>
#include <tumble/exact/jacobi.hpp>
#include <tumble/top.hpp>

namespace tumble::exact {

/// Where a top that no torque acts on will be. Made once from a state, asked as often as one likes.
///
/// The angle from the true orientation and the error of L relative to |L| stay below some tens of
/// roundings times 1 + |ω| t, where ω is the fastest spin and t the time, for any moments, also in
/// a ratio of a million. Near the edge between the two kinds of motion, where D_y is a small
/// difference of large terms, time itself is that uncertain: each flip adds the rounding of D_y,
/// relative to D_y, see time_uncertainty(). A part of L whose square, relative to |L|², is below
/// the range of numbers counts as none, also beside the middle axis, where it would grow. The sign
/// of the quaternion may be either.
template <class Real>
class FreeTop {
 public:
  /// A locked axis (inverse moment 0) leaves a top that turns steadily, as in chapter 8.
  explicit FreeTop(const Top<Real>& start) : start_(start), steady_(has_nothing_to_solve()) {
    if (!steady_) solve();
  }

  /// The top `time` seconds after the start; before it, if that is negative.
  Top<Real> at(Real time) const {
    Top<Real> top = start_;
    if (steady_) {
      top.orientation = start_.orientation * turn_about(angular_velocity_body(start_), time);
      return top;
    }
    const Real u = first_argument_ + argument_rate_ * time;
    const SnCnDn<Real> now = jacobi_.at(u);
    const Vec3<Real> L(amplitude_[0] * now.cn, amplitude_[1] * now.sn, amplitude_[2] * now.dn);
    for (std::size_t n = 0; n < 3; ++n)
      top.angular_momentum_body[axis_[n]] = momentum_unit_ * (sign_[n] * L[static_cast<int>(n)]);

    Real around = mean_rate_ * time + quick_angle(now) - quick_angle(first_);
    if (third_factor_ != 0) around += third_factor_ * (third_kind(u) - first_third_kind_);
    const Quaternion<Real> about_L{.real = std::cos(around / 2),
                                   .imaginary = {0, 0, std::sin(around / 2)}};
    const Quaternion<Real> turn =
        conjugate(to_momentum(first_momentum_)) * about_L * to_momentum(L);
    Quaternion<Real> turn_body{.real = turn.real};
    for (std::size_t n = 0; n < 3; ++n)
      turn_body.imaginary[axis_[n]] = sign_[n] * turn.imaginary[static_cast<int>(n)];
    top.orientation = normalized(start_.orientation * turn_body);
    return top;
  }

  /// After so many seconds L is back where it was in the body. It flips at half that time. Infinite
  /// for a steady spin, and on the edge between the two kinds of motion.
  Real period() const {
    return steady_ ? std::numeric_limits<Real>::infinity()
                   : 4 * jacobi_.quarter_period() / argument_rate_;
  }

  /// By how many seconds L may be early or late on its way after `time` seconds (s), because D_y is
  /// rounded; the angle is then off by up to twice that times the fastest spin.
  ///
  /// D_y rounds five times, relative to its terms; let η be that relative to D_y. From one passing
  /// of the y axis to the next u grows by 2K, and that is off by up to η, since (1 − m) dK/dm ≤ ½.
  /// Until the first passing what was small grows by e^(λt) at most.
  Real time_uncertainty(Real time) const {
    if (steady_) return 0;
    const Real u = argument_rate_ * std::abs(time);
    const Real passings = 1 + u / (2 * jacobi_.quarter_period());
    return std::min(2 * std::expm1(u), cancellation_ * passings) *
           (5 * std::numeric_limits<Real>::epsilon() / 2) / argument_rate_;
  }

  /// m: 0 for a cone, 1 on the edge between the two kinds of motion.
  Real parameter() const { return jacobi_.parameter(); }

 private:
  /// True without L, and with a locked axis. Where else L × ω is zero, solve() finds out: one of
  /// the D_k vanishes then.
  bool has_nothing_to_solve() const {
    return start_.angular_momentum_body.isZero(0) || (start_.inverse_moments.array() == 0).any();
  }

  static Quaternion<Real> turn_about(const Vec3<Real>& spin, Real time) {
    const Real half_rate = spin.norm() / 2, half = half_rate * time;
    if (half_rate == 0) return {};
    return {.real = std::cos(half), .imaginary = std::sin(half) * (spin / (2 * half_rate))};
  }

  /// The power of two that is next below the largest component: to divide by it rounds nothing.
  static Real power_of_two(const Vec3<Real>& v) {
    const Real largest = std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    return std::ldexp(Real(1), std::ilogb(largest));
  }

  /// Measures L and 1/I in units of their own size, so that no product leaves the range of numbers.
  void solve() {
    momentum_unit_ = power_of_two(start_.angular_momentum_body);
    const Real inverse_unit = power_of_two(start_.inverse_moments);
    const Vec3<Real> inverse = start_.inverse_moments / inverse_unit;
    const Vec3<Real> l = start_.angular_momentum_body / momentum_unit_;
    const Real size = l.norm(), twice_energy = dot(l, inverse.cwiseProduct(l));
    const auto excess = [&](int k) {  // D_k, from the terms that don't cancel
      Real sum = 0;
      for (int n = 0; n < 3; ++n) sum += l[n] * l[n] * (inverse[k] - inverse[n]);
      return sum;
    };
    std::sort(axis_.begin(), axis_.end(), [&](int p, int q) { return inverse[p] > inverse[q]; });
    if (excess(axis_[1]) < 0) std::swap(axis_[0], axis_[2]);
    if ((axis_[0] + 1) % 3 != axis_[1]) sign_[1] = -1;
    const auto [x, y, z] = axis_;
    const Real x_y = inverse[x] - inverse[y], y_z = inverse[y] - inverse[z],
               x_z = inverse[x] - inverse[z];
    const Real D_x = excess(x), D_y = excess(y), D_z = excess(z);
    const Real square = y_z * D_x, rate = std::sqrt(square);
    first_momentum_ = {l[x], sign_[1] * l[y], l[z]};
    // L is so close to its axis z, or to the plane of two like axes, that the square of the angle
    // is no number.
    steady_ = D_z == 0 || square == 0;
    if (steady_) return;

    // dn never changes sign, cn begins with the sign of L_x, and λ > 0 leaves one sign to sn.
    amplitude_ = {std::copysign(std::sqrt(-D_z / x_z), l[x]), std::sqrt(-D_z / y_z),
                  std::copysign(std::sqrt(D_x / x_z), l[z])};
    if ((amplitude_[0] < 0) != (amplitude_[2] < 0)) amplitude_[1] = -amplitude_[1];
    if (x_z < 0) amplitude_[1] = -amplitude_[1];

    const Real m = std::min(x_y * -D_z / square, Real(1)),
               one_minus_m = std::min(x_z * D_y / square, Real(1));
    const Real sn = first_momentum_[1] / amplitude_[1], cn = first_momentum_[0] / amplitude_[0];
    steady_ = cn * cn + one_minus_m * (sn * sn) == 0;  // as close to the middle axis
    if (steady_) return;
    jacobi_ = Jacobi<Real>(m, one_minus_m);
    first_argument_ = jacobi_.argument_of(sn, cn);
    first_ = jacobi_.at(first_argument_);
    cancellation_ = (l[x] * l[x] * std::abs(x_y) + l[z] * l[z] * std::abs(y_z)) / std::abs(D_y);
    argument_rate_ = rate * inverse_unit * momentum_unit_;
    mean_rate_ = twice_energy / size * inverse_unit * momentum_unit_;
    third_factor_ = D_y / (rate * size);
    n_ = x_y * (size * size) / D_x;
    one_minus_n_ = D_y / D_x;
    quick_factor_ = x_y * size / rate;
    if (third_factor_ != 0) first_third_kind_ = third_kind(first_argument_);
  }

  Real third_kind(Real u) const { return jacobi_.third_kind(n_, one_minus_n_, u); }

  Real quick_angle(const SnCnDn<Real>& at) const {
    return std::atan(quick_factor_ * (at.sn * (at.cn / at.dn)));
  }

  /// From the axes x, y, z of the body to axes of which the third is L, where the body's z has the
  /// azimuth 0: Euler's turns by the angle at which L is seen around z, then by θ.
  static Quaternion<Real> to_momentum(const Vec3<Real>& L) {
    const Real half_angle = std::atan2(std::hypot(L.x(), L.y()), L.z()) / 2,
               half_seen = std::atan2(L.y(), -L.x()) / 2;
    const Real c = std::cos(half_angle), s = std::sin(half_angle);
    const Real cosine = std::cos(half_seen), sine = std::sin(half_seen);
    return {.real = c * cosine, .imaginary = {s * sine, s * cosine, c * sine}};
  }

  Top<Real> start_;
  bool steady_ = true;
  std::array<int, 3> axis_ = {0, 1, 2};   // which body axes x, y and z are
  std::array<Real, 3> sign_ = {1, 1, 1};  // that makes x, y, z right-handed
  std::array<Real, 3> amplitude_ = {};    // of L along x, y and z, in units of momentum_unit_
  Vec3<Real> first_momentum_ = Vec3<Real>::Zero();  // at the start, along x, y and z
  Real momentum_unit_ = 1;
  Jacobi<Real> jacobi_{0, 1};
  SnCnDn<Real> first_;
  Real first_argument_ = 0, argument_rate_ = 0, mean_rate_ = 0, quick_factor_ = 0;
  Real n_ = 0, one_minus_n_ = 1, cancellation_ = 1, third_factor_ = 0, first_third_kind_ = 0;
};

}  // namespace tumble::exact
