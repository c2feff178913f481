/// @file
/// Exercise: a push with two cases, for many balls at once.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/pack.hpp>
#include <vector>

/// The push (N, upward) of soft ground on a ball whose lowest point is at `height` (m) and moves
/// upward with `speed` (m/s). At the depth d below 0 the ground pushes with 4000 d^(3/2) (1 −
/// speed/2), where that is more than nothing: it never pulls. Above 0 there is no push.
///
/// `Real` may be a pack, so there is no `if` on a number.
template <class Real>
Real ground_push(Real height, Real speed) {
  todo("the push below the ground, and zero above it, by select");
}

/// The pushes on many balls, as many at once as 16 bytes hold: four in float, two in double. The
/// count must be a multiple of that.
template <class Real>
std::vector<Real> pushes_in_packs(const std::vector<Real>& heights,
                                  const std::vector<Real>& speeds) {
  constexpr std::size_t width = 16 / sizeof(Real);
  using Several = tumble::Pack<Real, static_cast<int>(width)>;
  std::vector<Real> pushes;
  for (std::size_t first = 0; first < heights.size(); first += width) {
    Several height(0), speed(0);
    for (std::size_t lane = 0; lane < width; ++lane) {
      height.lanes[lane] = heights[first + lane];
      speed.lanes[lane] = speeds[first + lane];
    }
    const Several push = ground_push(height, speed);
    for (std::size_t lane = 0; lane < width; ++lane) pushes.push_back(push.lanes[lane]);
  }
  return pushes;
}
