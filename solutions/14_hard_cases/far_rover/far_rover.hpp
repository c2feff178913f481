/// @file
/// Exercise: a place that keeps its millimetres, however far away it is.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/far_from_origin.hpp>
#include <tumble/real.hpp>

/// How long and wide and high a cell is, m.
template <class Real>
constexpr Real cell_size = Real(1024);

/// A place is a cell, in whole numbers from the origin, and an offset from the cell's middle in m:
/// cell_size * cell + offset. Moves whole cells from the offset to the cell, until no component of
/// the offset is beyond half a cell. The place is the same, to the bit. Exactly half a cell may be
/// left, or carried to the other side.
template <class Real>
void settle(tumble::Vec3<Real>& cell, tumble::Vec3<Real>& offset) {
  //! [solution] move whole cells from the offset to the cell
  for (int axis = 0; axis < 3; ++axis) {
    const Real whole = std::round(offset[axis] / cell_size<Real>);
    cell[axis] += whole;
    offset[axis] -= whole * cell_size<Real>;
  }
  //! [end]
}

/// The way (m) from one place to another. Between neighbours it is as exact as if both were at the
/// origin.
template <class Real>
tumble::Vec3<Real> way_between(const tumble::Vec3<Real>& from_cell,
                               const tumble::Vec3<Real>& from_offset,
                               const tumble::Vec3<Real>& to_cell,
                               const tumble::Vec3<Real>& to_offset) {
  //! [solution] the way, without going through the origin
  return cell_size<Real> * (to_cell - from_cell) + (to_offset - from_offset);
  //! [end]
}

/// The slowest speed (m/s) that still moves a rover, wherever it is, in steps of `time_step` (s),
/// after each of which it is settled.
template <class Real>
Real slowest_drive(Real time_step) {
  //! [solution] the slowest speed that moves the largest offset
  return tumble::slowest_drift_at<Real>(std::nextafter(cell_size<Real> / 2, Real(0)), time_step);
  //! [end]
}

/// Drives: `steps` steps with `velocity` (m/s), and returns the way from where it began.
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
