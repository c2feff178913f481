/// @file
/// A free top, reduced to what is unknown of it: where L points in the body, and one angle.
#pragma once

#include <tumble/runge_kutta.hpp>
#include <tumble/step_control.hpp>

namespace tumble {

/// Euler's equations know nothing of the orientation: l = L/|L|, three numbers, obey
/// l' = |L| l × I⁻¹ l. And L stands still in the world, so that one further angle says how the body
/// stands. Let e be a fixed direction in the body, and s the shortest turn that takes l to it. Then
/// the orientation is b a s, where b is constant and a is a turn about e by an angle ψ. The rate of
/// ψ is ω · l less the component along l of the angular velocity of s,
///
///     ψ' = ω · (l + e)/(1 + l · e),
///
/// a mere integral: no stage needs ψ. L is fixed in the world to within rounding, however large the
/// errors of l and ψ. For e we take the axis that L goes around, the first or the last, on the side
/// where L is and stays: then 1 + l · e is at least 1, and ω · l is 2E/|L|, a constant.
//! [free_turn]
template <class Real>
class FreeTurn {
 public:
  explicit FreeTurn(const Top<Real>& top) : top_(top) {
    const Vec3<Real>&i = top.inverse_moments, &L = top.angular_momentum_body;
    // In a unit of its own size, so that a small L has a square. It is a power of two: nothing
    // rounds.
    const Real unit = std::ldexp(Real(1), std::ilogb(L.cwiseAbs().maxCoeff()));
    const Real length = (L / unit).norm();
    size_ = length * unit;
    inverse_ = size_ * i;
    differences_ = size_ * Vec3<Real>(i[2] - i[1], i[0] - i[2], i[1] - i[0]);
    begin_at(L / unit / length);
  }

  /// l', 1/s.
  [[gnu::always_inline]] StateVector<Real, 3> rates(const StateVector<Real, 3>& l, Real = 0) const {
    return {differences_[0] * (l[1] * l[2]), differences_[1] * (l[2] * l[0]),
            differences_[2] * (l[0] * l[1])};
  }

  /// ψ', rad/s, by the component of l along e.
  [[gnu::always_inline]] Real twist_rate(const StateVector<Real, 3>& l) const {
    const Real along = side_ * l[axis_];
    return (twice_energy_ + inverse_along_ * along) / (1 + along);
  }
  //! [free_turn]

  /// True if errors have led l to the far side of e: change_chart() is due.
  bool is_far(const StateVector<Real, 3>& l) const { return side_ * l[axis_] < Real(-0.5); }

  /// The top whose L points along l, with the angle ψ = `twist`, rad.
  Top<Real> top_at(const StateVector<Real, 3>& state, Real twist) const {
    const Vec3<Real> l = Vec3<Real>(state[0], state[1], state[2]).normalized();
    const Quaternion<Real> a = quaternion_of_rotation_vector<Real>(twist * e());
    Top<Real> top = top_;
    top.angular_momentum_body = size_ * l;
    top.orientation = normalized(base_ * a * shortest_from(l));
    return top;
  }

  /// Starts anew from where the top is now.
  void change_chart(const StateVector<Real, 3>& l, Real twist) {
    top_ = top_at(l, twist);
    begin_at(top_.angular_momentum_body / size_);
  }

  /// The square of the angle to which an error of l amounts.
  [[gnu::always_inline]] Real square(const StateVector<Real, 3>& off,
                                     const StateVector<Real, 3>&) const {
    return off[0] * off[0] + off[1] * off[1] + off[2] * off[2];
  }

  /// l at the start.
  StateVector<Real, 3> state() const { return {first_[0], first_[1], first_[2]}; }

 private:
  void begin_at(const Vec3<Real>& l) {
    first_ = l;
    twice_energy_ = dot(l, inverse_.cwiseProduct(l));
    // L goes around the outer axis on whose side of the middle one the energy lies.
    const Real low = inverse_.minCoeff(), high = inverse_.maxCoeff();
    const Real middle = inverse_.sum() - low - high;
    const Real wanted = twice_energy_ > middle ? high : low;
    axis_ = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (inverse_[axis] == wanted && (inverse_[static_cast<int>(axis_)] != wanted ||
                                       std::abs(l[axis]) > std::abs(l[static_cast<int>(axis_)])))
        axis_ = static_cast<std::size_t>(axis);
    side_ = l[static_cast<int>(axis_)] < 0 ? Real(-1) : Real(1);
    inverse_along_ = inverse_[static_cast<int>(axis_)];
    base_ = normalized(top_.orientation * conjugate(shortest_from(l)));
  }

  Vec3<Real> e() const { return side_ * Vec3<Real>::Unit(static_cast<int>(axis_)); }

  /// The turn that takes l to e, not normalised.
  Quaternion<Real> shortest_from(const Vec3<Real>& l) const {
    return {.real = 1 + dot(l, e()), .imaginary = l.cross(e())};
  }

  Top<Real> top_;
  Quaternion<Real> base_;             // b
  std::size_t axis_ = 0;              // that e lies along,
  Real side_ = 1;                     // and on which side
  Real size_, twice_energy_ = 0;      // |L|, kg m²/s; 2E/|L|, rad/s
  Vec3<Real> inverse_, differences_;  // |L|/I and differences of it, rad/s
  Real inverse_along_ = 0;            // |L|/I along e
  Vec3<Real> first_;
};

/// A free top by a Runge–Kutta rule on l, with ψ as an integral on the way. L is kept in the world.
template <class Rule, class Real>
[[gnu::flatten]] void turn_by_momentum(Top<Real>& top, Same<Real> time_step) {
  if (!is_gyroscopic(top) || (top.angular_momentum_body.array() == 0).all())
    return turn_steadily(top, time_step);
  const FreeTurn<Real> free(top);
  StateVector<Real, 3> state = free.state();
  Real twist = 0;
  step_reduced<Rule>(free, state, twist, 0, time_step);
  top = free.top_at(state, twist);
}

}  // namespace tumble
