/// @file
/// How far three columns are from axes: of length 1, perpendicular, right-handed.
#pragma once

#include <algorithm>
#include <tumble/require.hpp>

namespace tumble {

/// The largest element of RᵀR − 1, without its sign: 0 for columns of length 1 that are
/// perpendicular to each other, infinite where a square leaves the range of numbers. The columns
/// must be finite.
template <class Real>
Real orthonormality_error(const Mat3<Real>& R) {
  Real largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) {
      const Vec3<Real> a = R.col(i), b = R.col(j);
      largest = std::max(largest, std::abs(dot(a, b) - (i == j ? 1 : 0)));
    }
  return largest;
}

/// The determinant of R as the triple product of its columns: +1 for right-handed axes, −1 for
/// left-handed ones.
template <class Real>
Real triple_product(const Mat3<Real>& R) {
  const Vec3<Real> a = R.col(0), b = R.col(1), c = R.col(2);
  return dot(a.cross(b), c);
}

}  // namespace tumble
