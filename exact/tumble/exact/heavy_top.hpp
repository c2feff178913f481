/// @file
/// The exact motion of the heavy symmetric top: a top that spins on a fixed point, its axis pulled
/// by its weight.
///
/// I₁ is the moment about the fixed point across the axis e₃, I₃ the one about it. Up is the unit
/// vector that the weight opposes, P = M g l its size times the distance l of the centre of mass
/// from the fixed point, and z = e₃ · up the cosine of the tilt θ. Constant are L₃ along the axis,
/// L_z along up, and the energy. They leave one equation (Goldstein, Classical Mechanics, "The
/// heavy symmetrical top with one point fixed"):
///
///     z'² = f(z) = (T₀ − β (z − z₀))(1 − z²) − (L_z − L₃ z)²/I₁²,
///     T₀ = (L₁² + L₂²)/I₁² at the start,  β = 2P/I₁.
///
/// f has roots z₁ ≤ z₂ ≤ 1 ≤ z₃, and the tilt swings between the first two:
///
///     z = z₁ + (z₂ − z₁) sn² u,  u = λ t + u₀,  λ² = β (z₃ − z₁)/4,  m = (z₂ − z₁)/(z₃ − z₁).
///
/// The precession φ and the spin ψ about the axis follow from
/// φ' = (L_z − L₃ z)/(I₁ (1 − z²)) and ψ' = L₃/I₃ − z φ'. As partial fractions,
/// φ = φ₊ + φ₋ and ψ = φ₊ − φ₋ + (1/I₃ − 1/I₁) L₃ t with
///
///     φ±' = (L_z ± L₃)/(2 I₁ (1 ± z)):
///
/// two integrals of the third kind. Where the axis passes close to upright, φ₋ makes half a turn in
/// no time; hanging, φ₊ does. The form of the integral that puts this into an arc tangent
/// (Abramowitz and Stegun 17.7) has the factor ±1 before it, since f(±1) = −(L_z ∓ L₃)²/I₁². And as
/// the quaternion of Euler's three turns is cos(θ/2), (φ + ψ)/2 and sin(θ/2), (φ − ψ)/2 (Klein and
/// Sommerfeld), each of the two comes with the factor that vanishes where it is undefined.
#pragma once

#include <algorithm>
#include <tumble/exact/jacobi.hpp>
#include <tumble/exact/pi.hpp>
#include <tumble/top.hpp>

namespace tumble::exact {

/// The three roots of f, as distances that keep their digits: each may be small.
template <class Real>
struct TiltRoots {
  Real below_start = 0;  ///< z₀ − z₁
  Real above_start = 0;  ///< z₂ − z₀
  Real top_gap = 0;      ///< 1 − z₂
  Real third_gap = 0;    ///< z₃ − 1
  Real low_gap = 0;      ///< 1 − z₁
};

/// Where a heavy symmetric top will be. Made once from a state, asked as often as one likes.
///
/// The angle from the true orientation stays below some tens of roundings times 1 + ω t, with the
/// fastest rate in play, 1/(1 − m) times as much where the axis all but comes to rest upright. The
/// sign of the quaternion may be either.
template <class Real>
class HeavyTop {
 public:
  /// `start` has its moments about the fixed point, equal ones about its first two axes, and the
  /// third is the axis of symmetry; its torque is ignored. `pull` (N m, world axes) is the
  /// weight times the distance from the fixed point to the centre of mass: the torque is e₃ × pull.
  /// @throws std::invalid_argument if the first two inverse moments differ, if one is 0, or if the
  /// pull is zero or not finite; without a pull it is a FreeTop.
  HeavyTop(const Top<Real>& start, const Vec3<Real>& pull) : start_(start) {
    const Vec3<Real>& i = start.inverse_moments;
    if (i.x() != i.y() || !(i.x() > 0) || !(i.z() > 0))
      reject("inverse moments of a heavy top", i, "1/(kg m^2)",
             "the first two must be equal, and all greater than 0");
    require_finite("pull", pull, "N m");
    const Real size = pull.norm();
    if (!(size > 0)) reject("pull", pull, "N m", "it must not be zero; without it the top is free");
    up_body_ = rotate_back(start.orientation, Vec3<Real>(-pull));
    up_body_ /= up_body_.norm();
    const Vec3<Real>& L = start.angular_momentum_body;
    spin_excess_ = (i.z() - i.x()) * L.z();
    steady_ = L.x() == 0 && L.y() == 0 && up_body_.x() == 0 && up_body_.y() == 0;
    if (steady_)
      roots_.low_gap = roots_.top_gap = 1 - up_body_.z();
    else
      solve(size);
  }

  /// The top `time` seconds after the start; before it, if that is negative.
  Top<Real> at(Real time) const {
    Top<Real> top = start_;
    if (steady_) {
      const Real half = start_.inverse_moments.z() * start_.angular_momentum_body.z() * time / 2;
      const Quaternion<Real> turn{.real = std::cos(half), .imaginary = {0, 0, std::sin(half)}};
      top.orientation = start_.orientation * turn;
      return top;
    }
    const Real u = first_argument_ + rate_ * time;
    const SnCnDn<Real> now = off_zero(jacobi_.at(u));
    const Real plus = plus_angle(u, now) - first_plus_, minus = minus_angle(u, now) - first_minus_;
    const Real precession_and_spin = 2 * plus + spin_excess_ * time,
               precession_less_spin = 2 * minus - spin_excess_ * time;

    // Euler's z–y–z turns, in axes of which the third is up.
    const Real across = std::sqrt(lower(now) / 2), along = std::sqrt(upper(now) / 2);
    const Real sum = precession_and_spin / 2, difference = precession_less_spin / 2;
    const Real seen = first_seen_;
    const Quaternion<Real> turned{
        .real = along * std::cos(sum + seen / 2),
        .imaginary = {-across * std::sin(difference - seen / 2),
                      across * std::cos(difference - seen / 2), along * std::sin(sum + seen / 2)}};
    const Quaternion<Real> body_to_up = normalized(turned);
    top.orientation = normalized(up_to_world_ * body_to_up);

    // L across the axis: along the part of up that is perpendicular to it, L_z − L₃ z; and I₁ θ'.
    const Real gap = std::sqrt(lower(now) * upper(now));  // sin θ
    const Vec3<Real> up = rotate_back(body_to_up, Vec3<Real>(0, 0, 1));
    const Real direction = std::atan2(up.y(), up.x());
    const Real outwards =
        (lower(now) * momentum_sum_ + upper(now) * momentum_difference_) / 2 / gap;
    const Real swing =
        2 * tilt_range_ * rate_ * now.sn * now.cn * now.dn / gap * (1 / start_.inverse_moments.x());
    const Real cosine = std::cos(direction), sine = std::sin(direction);
    top.angular_momentum_body.x() = outwards * cosine - swing * sine;
    top.angular_momentum_body.y() = outwards * sine + swing * cosine;
    return top;
  }

  /// After so many seconds the tilt is back where it was, and as fast. Infinite where it never is.
  Real nutation_period() const {
    return steady_ ? std::numeric_limits<Real>::infinity() : 2 * jacobi_.quarter_period() / rate_;
  }

  /// The cosine of the largest tilt.
  Real lowest() const { return 1 - roots_.low_gap; }
  /// The cosine of the smallest tilt.
  Real highest() const { return 1 - roots_.top_gap; }

 private:
  /// 1 − z and 1 + z, as sums of two positive terms.
  Real lower(const SnCnDn<Real>& at) const {
    return roots_.low_gap * (at.cn * at.cn) + roots_.top_gap * (at.sn * at.sn);
  }
  Real upper(const SnCnDn<Real>& at) const {
    return low_sum_ * (at.cn * at.cn) + high_sum_ * (at.sn * at.sn);
  }

  /// The instant at which the axis is exactly upright or hangs has no direction of its own; that of
  /// an instant beside it will do.
  static SnCnDn<Real> off_zero(SnCnDn<Real> at) {
    constexpr Real tiny =
        std::numeric_limits<Real>::epsilon() * std::numeric_limits<Real>::epsilon();
    if (at.sn == 0) at.sn = tiny;
    if (at.cn == 0) at.cn = tiny;
    return at;
  }

  void solve(Real pull) {
    const Vec3<Real>& L = start_.angular_momentum_body;
    const Real inverse = start_.inverse_moments.x();
    const Real z = up_body_.z(), beta = 2 * pull * inverse;
    const Real square_across = up_body_.x() * up_body_.x() + up_body_.y() * up_body_.y();
    const Real from_top = z > 0 ? square_across / (1 + z) : 1 - z;
    const Real from_bottom = z > 0 ? 1 + z : square_across / (1 - z);
    const Real outwards = L.x() * up_body_.x() + L.y() * up_body_.y();
    momentum_difference_ = outwards - L.z() * from_top;                          // L_z − L₃
    momentum_sum_ = outwards + L.z() * from_bottom;                              // L_z + L₃
    const Real swing = (up_body_.x() * L.y() - up_body_.y() * L.x()) * inverse;  // z'

    const Real across = (L.x() * L.x() + L.y() * L.y()) * (inverse * inverse),
               spin = L.z() * inverse;
    find_roots(beta, swing * swing,
               -2 * z * across - beta * square_across + 2 * spin * (outwards * inverse),
               2 * z * beta - across - spin * spin, from_top);
    const Real third_sum = 2 + roots_.third_gap;
    high_sum_ = 2 - roots_.top_gap;
    // f(−1) = −(L_z + L₃)²/I₁² = −β (1 + z₁)(1 + z₂)(1 + z₃), which keeps a small 1 + z₁.
    low_sum_ = momentum_sum_ * inverse * (momentum_sum_ * inverse) / (beta * high_sum_ * third_sum);
    tilt_range_ = roots_.below_start + roots_.above_start;
    const Real whole = roots_.low_gap + roots_.third_gap;  // z₃ − z₁
    rate_ = std::sqrt(beta * whole) / 2;
    jacobi_ = Jacobi<Real>(tilt_range_ / whole, (roots_.third_gap + roots_.top_gap) / whole);

    const Real unit = inverse / (2 * rate_);
    minus_factor_ = momentum_difference_ * unit / roots_.low_gap;
    upright_ = roots_.top_gap < roots_.third_gap;
    minus_n_ = upright_ ? roots_.low_gap / whole : tilt_range_ / roots_.low_gap;
    minus_one_minus_n_ = upright_ ? roots_.third_gap / whole : roots_.top_gap / roots_.low_gap;
    plus_linear_ = momentum_sum_ * unit / third_sum;
    plus_third_ =
        momentum_sum_ * unit * (roots_.third_gap + roots_.top_gap) / (third_sum * high_sum_);
    // Of the two forms the one whose n is farther from 1.
    const Real upper_two = roots_.third_gap + roots_.top_gap;  // z₃ − z₂
    hanging_ = low_sum_ * third_sum < whole * high_sum_;
    plus_n_ = hanging_ ? high_sum_ / third_sum : tilt_range_ * third_sum / (whole * high_sum_);
    plus_one_minus_n_ =
        hanging_ ? upper_two / third_sum : upper_two * low_sum_ / (whole * high_sum_);
    plus_over_ = tilt_range_ * std::sqrt(third_sum);
    plus_under_ = std::sqrt(whole * low_sum_ * high_sum_);

    const Real sn = std::sqrt(roots_.below_start), cn = std::sqrt(roots_.above_start);
    first_argument_ = tilt_range_ > 0 ? jacobi_.argument_of(swing < 0 ? -sn : sn, cn) : Real(0);
    const SnCnDn<Real> first = off_zero(jacobi_.at(first_argument_));
    first_plus_ = plus_angle(first_argument_, first);
    first_minus_ = minus_angle(first_argument_, first);
    // Exactly upright or hanging, the axis leaves in the direction in which it moves.
    const bool vertical = up_body_.x() == 0 && up_body_.y() == 0;
    first_seen_ = vertical ? std::atan2(-L.x(), -L.y()) : std::atan2(up_body_.y(), -up_body_.x());
    const Quaternion<Real> body_to_up{
        .real = std::sqrt(from_bottom / 2) * std::cos(first_seen_ / 2),
        .imaginary = {std::sqrt(from_top / 2) * std::sin(first_seen_ / 2),
                      std::sqrt(from_top / 2) * std::cos(first_seen_ / 2),
                      std::sqrt(from_bottom / 2) * std::sin(first_seen_ / 2)}};
    up_to_world_ = start_.orientation * conjugate(normalized(body_to_up));
  }

  /// The roots of c₀ + c₁ x + c₂ x² + β x³ with x = z − z₀ and c₀ ≥ 0: two around 0, one above.
  void find_roots(Real beta, Real c0, Real c1, Real c2, Real from_top) {
    // Newton's method comes down to the largest root from above, where the curve is convex.
    Real x3 = 1 + (std::abs(c0) + std::abs(c1) + std::abs(c2)) / beta;
    for (int n = 0; n < 400; ++n) {
      const Real value = c0 + x3 * (c1 + x3 * (c2 + x3 * beta)),
                 slope = c1 + x3 * (2 * c2 + x3 * 3 * beta);
      const Real next = x3 - value / slope;
      if (!(next < x3)) break;
      x3 = next;
    }
    x3 = std::max(x3, from_top);
    // What is left is β x² + q₁ x + q₀ with q₀ ≤ 0, whose roots have different signs.
    const Real q0 = -c0 / x3, q1 = (q0 - c1) / x3;
    const Real root = std::sqrt(q1 * q1 - 4 * beta * q0);
    const Real far = (std::abs(q1) + root) / (2 * beta),
               near = far > 0 ? -q0 / beta / far : Real(0);
    roots_.below_start = q1 > 0 ? far : near;
    roots_.above_start = q1 > 0 ? near : far;
    roots_.low_gap = from_top + roots_.below_start;
    // f(1) = −(L_z − L₃)²/I₁² = −β (1 − z₁)(1 − z₂)(z₃ − 1): the product of two of the gaps.
    const Real d = momentum_difference_ * start_.inverse_moments.x();
    const Real product = d * d / (beta * roots_.low_gap);
    if (roots_.above_start + roots_.below_start < x3 - roots_.above_start) {
      roots_.top_gap = from_top - roots_.above_start;
      roots_.third_gap = x3 - from_top;
      if (roots_.top_gap < roots_.third_gap)
        roots_.top_gap = product / roots_.third_gap;
      else
        roots_.third_gap = product / roots_.top_gap;
    } else {
      // The upper two are close together, around 1: known are their sum and their product.
      const Real difference = -c2 / beta - 2 * from_top + roots_.below_start;  // z₂ + z₃ − 2
      const Real half = std::abs(difference) / 2, larger = half + std::sqrt(half * half + product);
      roots_.third_gap = difference > 0 ? larger : product / larger;
      roots_.top_gap = difference > 0 ? product / larger : larger;
      roots_.above_start = c0 / (beta * roots_.below_start * (from_top + roots_.third_gap));
    }
  }

  /// Where the factor is 0 the integral may be infinite; the product is 0 then.
  Real times_third_kind(Real factor, Real n, Real one_minus_n, Real u) const {
    return factor == 0 ? Real(0) : factor * jacobi_.third_kind(n, one_minus_n, u);
  }

  /// ∫ (L_z + L₃)/(2 I₁ (1 + z)) dt.
  Real plus_angle(Real u, const SnCnDn<Real>& at) const {
    const Real sign = std::copysign(Real(1), momentum_sum_), size = std::abs(plus_third_);
    const Real quick = std::copysign(
        std::atan2(plus_over_ * std::abs(at.sn * at.cn), plus_under_ * at.dn), at.sn * at.cn);
    const Real third = times_third_kind(size, plus_n_, plus_one_minus_n_, u);
    if (!hanging_) return sign * (quick + third) + plus_linear_ * u;
    return sign * (quick + unwound_angle(size, u, at) + size * u - third) + plus_linear_ * u;
  }

  /// The angle of which the tangent is `factor` sn/(cn dn), going on over the half periods.
  Real unwound_angle(Real factor, Real u, const SnCnDn<Real>& at) const {
    const Real half_periods = jacobi_.whole_half_periods(u);
    const Real sign = std::fmod(half_periods, Real(2)) != 0 ? Real(-1) : Real(1);
    return std::atan2(factor * (sign * at.sn), sign * at.cn * at.dn) + half_periods * pi<Real>;
  }

  /// ∫ (L_z − L₃)/(2 I₁ (1 − z)) dt.
  Real minus_angle(Real u, const SnCnDn<Real>& at) const {
    if (!upright_) return times_third_kind(minus_factor_, minus_n_, minus_one_minus_n_, u);
    const Real size = std::abs(minus_factor_);
    return std::copysign(Real(1), momentum_difference_) *
           (unwound_angle(size, u, at) + size * u -
            times_third_kind(size, minus_n_, minus_one_minus_n_, u));
  }

  Top<Real> start_;
  Vec3<Real> up_body_ = Vec3<Real>::Zero();
  bool steady_ = true;
  bool upright_ = false, hanging_ = false;  // which form of the two integrals
  TiltRoots<Real> roots_;
  Jacobi<Real> jacobi_{0, 1};
  Quaternion<Real> up_to_world_;
  Real momentum_difference_ = 0, momentum_sum_ = 0;   // L_z − L₃ and L_z + L₃
  Real low_sum_ = 0, high_sum_ = 0, tilt_range_ = 0;  // 1 + z₁, 1 + z₂, z₂ − z₁
  Real spin_excess_ = 0, rate_ = 0, first_argument_ = 0, first_plus_ = 0, first_minus_ = 0,
       first_seen_ = 0;
  Real minus_factor_ = 0, minus_n_ = 0, minus_one_minus_n_ = 1;
  Real plus_linear_ = 0, plus_third_ = 0, plus_n_ = 0, plus_one_minus_n_ = 1, plus_over_ = 0,
       plus_under_ = 1;
};

}  // namespace tumble::exact
