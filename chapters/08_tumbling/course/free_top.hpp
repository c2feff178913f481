/// @file
/// The exact motion of a top without torque, in long double: what every rule of the chapter is
/// measured against.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <course/quadrature.hpp>
#include <numbers>
#include <tumble/euler_equations.hpp>
#include <vector>

namespace tumble::course {

/// The same numbers in long double: truth starts from the rounded values.
template <class Real>
Top<long double> exactly(const Top<Real>& top) {
  return {.orientation = normalized(Quaternion<long double>{
              top.orientation.real, top.orientation.imaginary.template cast<long double>()}),
          .angular_momentum_body = top.angular_momentum_body.template cast<long double>(),
          .torque = top.torque.template cast<long double>(),
          .inverse_moments = top.inverse_moments.template cast<long double>()};
}

/// Jacobi's sn, cn and dn for one argument.
struct JacobiFunctions {
  long double sn, cn, dn;
};

/// sn, cn and dn of u for the parameters m and m₁ = 1 − m, by the arithmetic-geometric mean: the
/// angle is doubled until nothing is left to bend, and halved back.
inline JacobiFunctions jacobi_functions(long double u, long double m, long double m1) {
  std::vector<long double> a = {1}, c = {std::sqrt(m)};
  long double b = std::sqrt(m1);
  while (c.back() > std::numeric_limits<long double>::epsilon() * a.back() && a.size() < 30) {
    const long double mean = (a.back() + b) / 2, half_gap = (a.back() - b) / 2;
    b = std::sqrt(a.back() * b);
    a.push_back(mean);
    c.push_back(half_gap);
  }
  long double angle = std::ldexp(a.back() * u, static_cast<int>(a.size()) - 1);
  for (std::size_t n = a.size() - 1; n > 0; --n)
    angle = (angle + std::asin(c[n] / a[n] * std::sin(angle))) / 2;
  const long double sn = std::sin(angle), cn = std::cos(angle);
  return {sn, cn, std::sqrt(cn * cn + m1 * sn * sn)};
}

/// A quarter of the period of sn and cn.
inline long double quarter_period(long double m1) {
  long double a = 1, b = std::sqrt(m1);
  for (int n = 0; n < 30; ++n) {
    const long double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::numbers::pi_v<long double> / (2 * a);
}

/// The motion from `start` on, with neither torque nor error.
class FreeTop {
 public:
  explicit FreeTop(const Top<long double>& start) : start_(start) {
    const Vec3<long double> torque = gyroscopic_torque(start);
    steady_ = (torque.array() == 0).all();
    if (!steady_) solve();
  }

  /// ω in body axes, rad/s, `time` seconds after the start.
  Vec3<long double> angular_velocity_body(long double time) const {
    if (steady_) return tumble::angular_velocity_body(start_);
    const auto [sn, cn, dn] = jacobi_functions(first_argument_ + rate_ * time, m_, m1_);
    Vec3<long double> w;
    w[axis_[0]] = amplitude_[0] * cn;
    w[axis_[1]] = amplitude_[1] * sn;
    w[axis_[2]] = amplitude_[2] * dn;
    return w;
  }

  Vec3<long double> angular_momentum_body(long double time) const {
    return angular_velocity_body(time).cwiseQuotient(start_.inverse_moments);
  }

  /// From body axes to world axes. The angular momentum stands still in the world; what is left to
  /// know is the angle by which the third axis has gone around it, an integral over time.
  Quaternion<long double> orientation(long double time) const {
    if (steady_)
      return quaternion_of_rotation_vector<long double>(time * angular_velocity_world(start_)) *
             start_.orientation;
    const Vec3<long double> L_world = angular_momentum_world(start_);
    const Vec3<long double> third = rotate(start_.orientation, third_axis());
    const Mat3<long double> body = triad(angular_momentum_body(time), third_axis());
    const Mat3<long double> world = triad(L_world, third);
    const long double angle = angle_around(time);
    Mat3<long double> around;
    around << 1, 0, 0, 0, std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle);
    return quaternion_of<long double>(world * around * body.transpose());
  }

  /// After so many seconds ω is back where it was in the body; the visible flips are half as far
  /// apart. Infinite on the edge between the two kinds of motion.
  long double period() const { return 4 * quarter_period(m1_) / rate_; }
  long double parameter() const { return m_; }

 private:
  /// Right-handed axes along L, along the part of `other` that is square to L, and square to both.
  static Mat3<long double> triad(const Vec3<long double>& L, const Vec3<long double>& other) {
    const Vec3<long double> along = L.normalized();
    const Vec3<long double> across = (other - along * along.dot(other)).normalized();
    Mat3<long double> axes;
    axes << along, across, along.cross(across);
    return axes;
  }

  Vec3<long double> third_axis() const { return Vec3<long double>::Unit(axis_[2]); }

  /// The third axis goes around L at the rate |L| (L₁ω₁ + L₂ω₂)/(L₁² + L₂²). Gauss and Legendre's
  /// four points in panels of a twentieth of a radian add that up to the last digits.
  long double angle_around(long double time) const {
    const long double size = start_.angular_momentum_body.norm();
    const auto rate = [&](long double at) {
      const Vec3<long double> w = angular_velocity_body(at), L = angular_momentum_body(at);
      const int i = axis_[0], j = axis_[1];
      return size * (L[i] * w[i] + L[j] * w[j]) / (L[i] * L[i] + L[j] * L[j]);
    };
    const long double fastest = tumble::angular_velocity_body(start_).norm() + rate_;
    const int panels = 1 + static_cast<int>(std::abs(time) * fastest * 20);
    const long double width = time / panels;
    long double sum = 0;
    for (int panel = 0; panel < panels; ++panel)
      for (const Node& node : gauss_legendre())
        sum += node.weight * rate(width * (panel + node.at));
    return sum * width;
  }

  void solve() {
    const Vec3<long double> I = start_.inverse_moments.cwiseInverse();
    const Vec3<long double> w = tumble::angular_velocity_body(start_);
    std::sort(axis_.begin(), axis_.end(), [&](int i, int j) { return I[i] < I[j]; });
    const bool cyclic = (axis_[0] + 1) % 3 == axis_[1];
    // L² − 2 E I₂ tells which of the outer axes L goes around; that one must be the third.
    const auto excess = [&](int k) {  // of L² over 2 E I_k, from terms that don't cancel
      long double sum = 0;
      for (int i = 0; i < 3; ++i) sum += I[i] * (I[i] - I[k]) * w[i] * w[i];
      return sum;
    };
    if (excess(axis_[1]) < 0) std::swap(axis_[0], axis_[2]);
    const auto [a, b, c] = axis_;
    const long double over_first = excess(a), under_third = -excess(c), over_second = excess(b);
    const long double scale = (I[c] - I[b]) * over_first;
    m_ = (I[b] - I[a]) * under_third / scale;
    m1_ = (I[c] - I[a]) * over_second / scale;
    rate_ = std::sqrt(scale / (I[a] * I[b] * I[c]));
    const long double third_sign = w[c] < 0 ? -1 : 1,
                      second_sign = cyclic ? third_sign : -third_sign;
    amplitude_ = {std::sqrt(under_third / (I[a] * (I[c] - I[a]))),
                  second_sign * std::sqrt(under_third / (I[b] * (I[c] - I[b]))),
                  third_sign * std::sqrt(over_first / (I[c] * (I[c] - I[a])))};
    const long double angle = std::atan2(w[b] / amplitude_[1], w[a] / amplitude_[0]);
    first_argument_ = std::ellint_1(std::sqrt(m_), angle);
  }

  Top<long double> start_;
  bool steady_;
  std::array<int, 3> axis_ = {0, 1, 2};  // whose ω goes with cn, sn and dn
  std::array<long double, 3> amplitude_ = {};
  long double m_ = 0, m1_ = 1, rate_ = 0, first_argument_ = 0;
};

}  // namespace tumble::course
