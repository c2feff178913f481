// caught by: What comes is braked, what goes is pushed less, and nothing is ever pulled
// message: 4 m below the ground
#pragma once

#include <cmath>
#include <tumble/pack.hpp>
#include <vector>

template <class Real>
Real ground_push(Real height, Real speed) {
  using std::sqrt;
  using tumble::select;
  const Real depth = -height;
  const Real push = Real(4000) * (depth * sqrt(depth)) - Real(1000) * depth * speed;
  return select(height < Real(0), select(push > Real(0), push, Real(0)), Real(0));
}

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
