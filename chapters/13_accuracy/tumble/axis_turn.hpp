/// @file
/// A symmetric top under a torque on its axis, reduced to what is unknown of it: where the axis
/// points, L, and one angle.
#pragma once

#include <tumble/runge_kutta.hpp>

namespace tumble {

/// The equations of a symmetric top's axis c do not contain the angle of the spin about it. In the
/// world, with i for the inverse of the two equal moments and Λ = i L,
///
///     c' = Λ × c,  Λ' = i τ(c, t),
///
/// and where τ has no part along c, L · c is constant. One further angle says how the body stands:
/// its orientation is s⁻¹ a b, where s is the shortest turn that takes c to a fixed direction n, a
/// is a turn about n by an angle ψ, and b is constant. With ω = Λ + k c, where k = (i_c − i) L · c,
///
///     ψ' = ω · (c + n)/(1 + c · n) = k + Λ · (c + n)/(1 + c · n),
///
/// an integral that no stage needs. A top that spins fast needs no short steps for that: the spin
/// is in k. We take n along the z axis, up or down, where c is nearer; see change_chart() for when
/// it is not any more.
//! [axis_turn]
template <class Forces, class Real>
class AxisTurn {
 public:
  AxisTurn(const Top<Real>& top, const Forces& evaluate_forces)
      : evaluate_forces_(&evaluate_forces), top_(top) {
    const Vec3<Real>& i = top.inverse_moments;
    for (axis_ = 0; axis_ < 3 && i[(axis_ + 1) % 3] != i[(axis_ + 2) % 3]; ++axis_) continue;
    if (axis_ == 3 || (i.array() == 0).any())
      reject("inverse moments", i, "1/(kg m^2)",
             "two of them must be equal, and none 0, for a top that has an axis");
    inverse_ = i[(axis_ + 1) % 3];
    excess_ = (i[axis_] - inverse_) * top.angular_momentum_body[axis_];
    begin();
  }

  /// c' and Λ', 1/s and rad/s².
  [[gnu::always_inline]] StateVector<Real, 6> rates(const StateVector<Real, 6>& y,
                                                    Real time) const {
    const Vec3<Real> torque = evaluate_forces_->torque_on_axis(Vec3<Real>(y[0], y[1], y[2]), time);
    return {y[4] * y[2] - y[5] * y[1], y[5] * y[0] - y[3] * y[2], y[3] * y[1] - y[4] * y[0],
            inverse_ * torque[0],      inverse_ * torque[1],      inverse_ * torque[2]};
  }

  /// ψ', rad/s.
  [[gnu::always_inline]] Real twist_rate(const StateVector<Real, 6>& y) const {
    return excess_ + (y[3] * y[0] + y[4] * y[1] + y[5] * y[2] + side_ * y[5]) / (1 + side_ * y[2]);
  }
  //! [axis_turn]

  /// True if c is so far from n that change_chart() is due.
  bool is_far(const StateVector<Real, 6>& y) const { return side_ * y[2] < Real(-0.5); }

  /// The top in this state and the angle ψ = `twist`, rad.
  Top<Real> top_at(const StateVector<Real, 6>& y, Real twist) const {
    const Vec3<Real> c = Vec3<Real>(y[0], y[1], y[2]).normalized(), momentum(y[3], y[4], y[5]);
    const Quaternion<Real> a = quaternion_of_rotation_vector<Real>(twist * n());
    Top<Real> top = top_;
    top.orientation = normalized(conjugate(shortest_from(c)) * a * b_);
    const Real along = top.angular_momentum_body[axis_];  // it stays, to the bit
    top.angular_momentum_body = rotate_back<Real>(top.orientation, momentum / inverse_);
    top.angular_momentum_body[axis_] = along;
    return top;
  }

  /// Starts anew from where the top is now.
  void change_chart(const StateVector<Real, 6>& y, Real twist) {
    top_ = top_at(y, twist);
    begin();
  }

  /// The square of the angle that an error of c is, and of the part of |L| that one of Λ is.
  [[gnu::always_inline]] Real square(const StateVector<Real, 6>& off,
                                     const StateVector<Real, 6>& y) const {
    const Real all = y[3] * y[3] + y[4] * y[4] + y[5] * y[5],
               part = off[3] * off[3] + off[4] * off[4] + off[5] * off[5];
    return off[0] * off[0] + off[1] * off[1] + off[2] * off[2] + (part == 0 ? Real(0) : part / all);
  }

  /// c and Λ at the start.
  StateVector<Real, 6> state() const { return start_; }

 private:
  void begin() {
    const Vec3<Real> c = rotate<Real>(top_.orientation, Vec3<Real>::Unit(axis_));
    const Vec3<Real> momentum = inverse_ * angular_momentum_world(top_);
    start_ = {c[0], c[1], c[2], momentum[0], momentum[1], momentum[2]};
    side_ = c[2] < 0 ? Real(-1) : Real(1);
    b_ = normalized(shortest_from(c) * top_.orientation);
  }

  Vec3<Real> n() const { return {0, 0, side_}; }

  /// The turn that takes c to n, not normalised.
  Quaternion<Real> shortest_from(const Vec3<Real>& c) const {
    return {.real = 1 + dot(c, n()), .imaginary = c.cross(n())};
  }

  const Forces* evaluate_forces_;
  Top<Real> top_;
  Quaternion<Real> b_;
  int axis_ = 0;      // of the body, that is c
  Real side_ = 1;     // n is this times the z axis
  Real inverse_ = 0;  // i, 1/(kg m²)
  Real excess_ = 0;   // k, rad/s
  StateVector<Real, 6> start_ = {};
};

}  // namespace tumble
