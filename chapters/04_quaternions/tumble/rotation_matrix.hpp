/// @file
/// Orientations as matrices, and back.
#pragma once

#include <algorithm>
#include <array>
#include <tumble/orthonormal.hpp>
#include <tumble/quaternion.hpp>

namespace tumble {

/// The matrix R with R v = q v q*: its columns are the body's axes in world axes. `q` must have
/// norm 1.
//! [matrix_of]
template <class Real>
Mat3<Real> matrix_of(const Quaternion<Real>& q) {
  const Vec3<Real> u = q.imaginary, twice = 2 * u;
  const Real xx = twice.x() * u.x(), yy = twice.y() * u.y(), zz = twice.z() * u.z();
  const Real xy = twice.x() * u.y(), yz = twice.y() * u.z(), zx = twice.z() * u.x();
  const Vec3<Real> w = q.real * twice;
  Mat3<Real> matrix;
  matrix.row(0) << 1 - (yy + zz), xy - w.z(), zx + w.y();
  matrix.row(1) << xy + w.z(), 1 - (xx + zz), yz - w.x();
  matrix.row(2) << zx - w.y(), yz + w.x(), 1 - (xx + yy);
  return matrix;
}
//! [matrix_of]

/// @throws std::invalid_argument unless the columns of `matrix` have length 1 and are perpendicular
/// to each other, and right-handed. Each element of RᵀR − 1 may be off by 0.01, so that a length,
/// of which it holds the square, may be off by 0.005.
template <class Real>
void require_nearly_rotation(std::string_view name, const Mat3<Real>& matrix) {
  for (int column = 0; column < 3; ++column)
    require_finite<Real>("a column of " + std::string(name), matrix.col(column), "");
  const Real largest = orthonormality_error(matrix);
  if (!(largest <= Real(0.01)))
    reject("the largest element of RᵀR − 1 for " + std::string(name), largest, "",
           "a rotation's columns have length 1 and are perpendicular to each other, within 0.01");
  if (!(triple_product(matrix) > 0))
    reject("the determinant of " + std::string(name), triple_product(matrix), "",
           "a rotation's is +1; this is a mirror");
}

/// The quaternion of a rotation matrix R, with real part 0 or more.
///
/// From matrix_of() one reads off 1 + tr R = 4 w², the differences across R's diagonal 4 w u, and
/// R + Rᵀ + (1 − tr R) 1 = 4 u uᵀ. Together they are the sixteen products of q's components, four
/// times each, so every column of the table below is a multiple of q. The one with the largest
/// diagonal element has lost no digits: it is normalised. At 180° the first column is zero.
/// @throws std::invalid_argument if the matrix called `name` is not a rotation, see
/// require_nearly_rotation().
//! [quaternion_of]
template <class Real>
Quaternion<Real> quaternion_of(const Mat3<Real>& R, std::string_view name = "rotation") {
  require_nearly_rotation(name, R);
  const Real trace = R.trace(), rest = 1 - trace;
  const Real wx = R(2, 1) - R(1, 2), wy = R(0, 2) - R(2, 0), wz = R(1, 0) - R(0, 1);
  const Real xy = R(0, 1) + R(1, 0), yz = R(1, 2) + R(2, 1), zx = R(2, 0) + R(0, 2);
  const std::array<Real, 4> squares = {1 + trace, 2 * R(0, 0) + rest, 2 * R(1, 1) + rest,
                                       2 * R(2, 2) + rest};
  const auto [ww, xx, yy, zz] = squares;
  const std::array<Quaternion<Real>, 4> columns = {{
      {.real = ww, .imaginary = {wx, wy, wz}},
      {.real = wx, .imaginary = {xx, xy, zx}},
      {.real = wy, .imaginary = {xy, yy, yz}},
      {.real = wz, .imaginary = {zx, yz, zz}},
  }};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const Quaternion<Real>& q = columns[static_cast<std::size_t>(largest)];
  return normalized(q.real < 0 ? -q : q);
}
//! [quaternion_of]

}  // namespace tumble
