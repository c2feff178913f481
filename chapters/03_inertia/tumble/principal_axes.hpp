/// @file
/// The axes in which a tensor is three numbers.
#pragma once

#include <array>
#include <tumble/inertia.hpp>
#include <tumble/orthonormal.hpp>
#include <utility>

namespace tumble {

/// The three moments of a tensor and the axes that they belong to: I = R diag(moments) Rᵀ, R being
/// `axes`.
template <class Real>
struct PrincipalAxes {
  Vec3<Real> moments;  ///< kg m², ascending
  Mat3<Real> axes;     ///< in its columns: length 1, perpendicular to each other, right-handed
};

/// Turns the frame in the plane of its axes p and q so that the product I_pq becomes 0: by the
/// angle −φ, that is from q towards p.
///
/// The new axes are p cos φ − q sin φ and p sin φ + q cos φ, and in them I_pq is (cos²φ − sin²φ)
/// I_pq + sin φ cos φ (I_pp − I_qq). With t = tan φ it is 0 when t² + 2θt − 1 = 0, where θ = (I_qq
/// − I_pp)/(2 I_pq). The root nearer to 0 turns by 45° at most.
//! [remove_product]
template <class Real>
void remove_product(Mat3<Real>& I, Mat3<Real>& axes, int p, int q) {
  const Real theta = (I(q, q) - I(p, p)) / (2 * I(p, q));
  // Where θ² overflows, t is 0: the product is far below a rounding of the moments.
  const Real t = std::copysign(Real(1), theta) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const Real cosine = 1 / std::sqrt(t * t + 1), sine = t * cosine;

  I(p, p) -= t * I(p, q);
  I(q, q) += t * I(p, q);
  I(p, q) = I(q, p) = 0;
  const int r = 3 - p - q;  // the axis that stays
  const Real I_rp = I(r, p), I_rq = I(r, q);
  I(r, p) = I(p, r) = cosine * I_rp - sine * I_rq;
  I(r, q) = I(q, r) = sine * I_rp + cosine * I_rq;

  for (int i = 0; i < 3; ++i) {
    const Real axis_p = axes(i, p), axis_q = axes(i, q);
    axes(i, p) = cosine * axis_p - sine * axis_q;
    axes(i, q) = sine * axis_p + cosine * axis_q;
  }
}
//! [remove_product]

/// The principal moments and axes of a symmetric tensor (kg m²), by Jacobi's method: turn one
/// product of inertia away after the other until none is left that matters.
///
/// A turn brings back a part of what the one before removed, but ever less: near the end, the
/// product of the two removed last, by a difference of moments. A product counts as gone once it is
/// below a rounding of the smaller of its two moments. A tensor that is diagonal already is not
/// touched: its numbers come out to the bit, in ascending order. Equal moments leave the choice of
/// axes free; some right-handed ones come out.
/// @throws std::invalid_argument if the tensor called `name` is not finite or not symmetric.
template <class Real>
PrincipalAxes<Real> principal_axes(const Mat3<Real>& inertia, std::string_view name = "body") {
  require_symmetric(name, inertia);
  const std::array planes = {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}};
  Mat3<Real> I = inertia, axes = Mat3<Real>::Identity();
  for (const auto [p, q] : planes) I(p, q) = I(q, p) = (inertia(p, q) + inertia(q, p)) / 2;
  const auto matters = [&I](int p, int q) {
    const Real smaller = std::min(std::abs(I(p, p)), std::abs(I(q, q)));
    return std::abs(I(p, q)) > std::numeric_limits<Real>::epsilon() / 2 * smaller;
  };
  const int most_sweeps = 30;  // five are usual
  for (int sweep = 0; sweep < most_sweeps; ++sweep)
    for (const auto [p, q] : planes)
      if (matters(p, q)) remove_product(I, axes, p, q);

  std::array<int, 3> order = {0, 1, 2};
  for (const std::size_t i : {0U, 1U, 0U})  // by swapping neighbours, so that equal ones keep order
    if (I(order[i + 1], order[i + 1]) < I(order[i], order[i])) std::swap(order[i], order[i + 1]);
  PrincipalAxes<Real> result;
  for (int i = 0; i < 3; ++i) {
    const int from = order[static_cast<std::size_t>(i)];
    result.moments(i) = I(from, from);
    result.axes.col(i) = axes.col(from);
  }
  if (triple_product(result.axes) < 0) result.axes.col(2) *= -1;
  return result;
}

}  // namespace tumble
