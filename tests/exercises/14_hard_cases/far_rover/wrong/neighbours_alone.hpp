// caught by: The way between neighbours keeps its digits, at the end of the world
// message: the way to a place 3, -2 and 5 cells further
#pragma once

#include <cmath>
#include <tumble/far_from_origin.hpp>
#include <tumble/real.hpp>

template <class Real>
constexpr Real cell_size = Real(1024);

template <class Real>
void settle(tumble::Vec3<Real>& cell, tumble::Vec3<Real>& offset) {
  for (int axis = 0; axis < 3; ++axis) {
    const Real whole = std::round(offset[axis] / cell_size<Real>);
    cell[axis] += whole;
    offset[axis] -= whole * cell_size<Real>;
  }
}

template <class Real>
tumble::Vec3<Real> way_between(const tumble::Vec3<Real>& from_cell,
                               const tumble::Vec3<Real>& from_offset,
                               const tumble::Vec3<Real>& to_cell,
                               const tumble::Vec3<Real>& to_offset) {
  return cell_size<Real> * (to_cell - from_cell).cwiseMax(Real(-1)).cwiseMin(Real(1)) +
         (to_offset - from_offset);
}

template <class Real>
Real slowest_drive(Real time_step) {
  return tumble::slowest_drift_at<Real>(std::nextafter(cell_size<Real> / 2, Real(0)), time_step);
}

template <class Real>
tumble::Vec3<Real> driven(const tumble::Vec3<Real>& cell, const tumble::Vec3<Real>& offset,
                          const tumble::Vec3<Real>& velocity, Real time_step, int steps) {
  tumble::Vec3<Real> to_cell = cell, to_offset = offset;
  for (int n = 0; n < steps; ++n) {
    to_offset += time_step * velocity;
    settle<Real>(to_cell, to_offset);
  }
  return way_between<Real>(cell, offset, to_cell, to_offset);
}
