/// @file
/// What the checks of every chapter share. A check's name is a sentence that states the fact it
/// checks.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tumble/real.hpp>

/// The kinds of number that checks run in. long double is not one of them: where it is used, it is
/// the witness that shows how much these two round.
#ifdef TUMBLE_ONE_PRECISION  // to search with, in half the time
#define EVERY_PRECISION TUMBLE_ONE_PRECISION
#else
#define EVERY_PRECISION float, double
#endif

namespace tumble::support {

/// Half the distance from 1 to the next number: the largest relative error of one correctly rounded
/// operation. The bounds in the checks are multiples of it, counted from the operations.
template <class Real>
constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// The largest absolute component of a difference.
template <class Real>
Real distance(const Vec3<Real>& a, const Vec3<Same<Real>>& b) {
  return std::max({std::abs(a.x() - b.x()), std::abs(a.y() - b.y()), std::abs(a.z() - b.z())});
}

/// True when all components are equal numbers: then every bit agrees, but that +0 and −0 count as
/// equal, since no motion tells them apart. A NaN equals nothing.
template <class First, class Second>
bool same_bits(const Eigen::MatrixBase<First>& a, const Eigen::MatrixBase<Second>& b) {
  const typename First::PlainObject left = a;
  const typename Second::PlainObject right = b;
  return std::equal(left.data(), left.data() + left.size(), right.data());
}

/// The sentence that `action` throws, or "nothing thrown".
template <class Action>
std::string complaint_of(const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing thrown";
}

}  // namespace tumble::support
