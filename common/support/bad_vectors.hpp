/// @file
/// Vectors of which one component is no number: what every check of an input is tried with.
#pragma once

#include <array>
#include <support/checks.hpp>
#include <tumble/require.hpp>
#include <vector>

namespace tumble::support {

/// What is not finite.
template <class Real>
constexpr std::array<Real, 3> not_finite = {std::numeric_limits<Real>::quiet_NaN(),
                                            std::numeric_limits<Real>::infinity(),
                                            -std::numeric_limits<Real>::infinity()};

/// (1, 2, 3) with x, y or z alone NaN, infinite or minus infinite: nine vectors.
template <class Real>
std::vector<Vec3<Real>> bad_vectors() {
  std::vector<Vec3<Real>> vectors;
  for (int axis = 0; axis < 3; ++axis)
    for (const Real bad : not_finite<Real>) {
      vectors.push_back({1, 2, 3});
      vectors.back()[axis] = bad;
    }
  return vectors;
}

/// Checks that `action` refuses each of them, with a sentence that begins with `name`, shows all
/// three components and has their unit.
template <class Real, class Action>
void check_refuses_bad_vectors(const std::string& name, const std::string& unit,
                               const Action& action) {
  for (const Vec3<Real>& bad : bad_vectors<Real>())
    CHECK(complaint_of([&] { action(bad); }) == name + " is " + text_of(bad) +
                                                    (unit.empty() ? "" : " " + unit) +
                                                    "; every component must be finite");
}

}  // namespace tumble::support
