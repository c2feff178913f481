/// @file
/// Bodies as plain arrays, one for each number that a body has: what a loop written by hand for
/// speed alone would run on.
#pragma once

#include <bit>
#include <memory>
#include <new>
#include <support/bench/setting.hpp>
#include <tumble/quaternion.hpp>

namespace tumble::support::bench {

/// The numbers of a body, in the order of their columns. Positions, velocities and torques are in
/// world axes, momenta and moments in body axes.
enum Column : std::size_t {
  position_x,
  position_y,
  position_z,
  velocity_x,
  velocity_y,
  velocity_z,
  orientation_real,
  orientation_x,
  orientation_y,
  orientation_z,
  momentum_x,
  momentum_y,
  momentum_z,
  torque_x,
  torque_y,
  torque_z,
  inverse_moment_x,
  inverse_moment_y,
  inverse_moment_z,
  column_count
};

/// How far apart the columns begin.
enum class Spacing {
  padded,       ///< an odd number of cache lines, so that no two columns meet in one set
  power_of_two  ///< as arrays of a round size happen to lie: all meet in the same few sets
};

inline constexpr std::size_t cache_line = 64;  // bytes

constexpr std::size_t column_stride(std::size_t bytes, Spacing spacing) {
  if (spacing == Spacing::power_of_two) return std::bit_ceil(bytes < 4096 ? 4096 : bytes);
  return ((bytes / cache_line + 1) | 1) * cache_line;
}

/// `count` bodies in columns of `Real`, as the scenes begin.
template <class Real>
class Columns {
 public:
  explicit Columns(std::size_t count, Spacing spacing = Spacing::padded)
      : count_(count),
        stride_(column_stride(count * sizeof(Real), spacing) / sizeof(Real)),
        numbers_(static_cast<Real*>(::operator new(stride_* column_count * sizeof(Real), page))) {
    for (std::size_t n = 0; n < count; ++n) begin(n);
  }

  std::size_t count() const { return count_; }
  Real* column(Column column) const { return numbers_.get() + stride_ * column; }

  Motion motion(std::size_t n) const {
    const auto three = [&](Column first) {
      return Vec3d(at(first, n), at(Column(first + 1), n), at(Column(first + 2), n));
    };
    const Quaterniond orientation{at(orientation_real, n), three(orientation_x)};
    const Vec3d spin = rotate(orientation, three(momentum_x).cwiseProduct(three(inverse_moment_x)));
    return {triple_of(three(position_x)), triple_of(three(velocity_x)), triple_of(spin)};
  }

 private:
  Real& at(Column column, std::size_t n) const { return numbers_[stride_ * column + n]; }

  void begin(std::size_t n) {
    const Start start = start_of(n);
    at(orientation_real, n) = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto set = [&](Column first, double value) {
        at(Column(first + axis), n) = static_cast<Real>(value);
      };
      set(position_x, start.position[axis]);
      set(velocity_x, start.velocity[axis]);
      set(orientation_x, 0);
      set(momentum_x, moments[axis] * start.angular_velocity[axis]);
      set(torque_x, torque[axis]);
      set(inverse_moment_x, 1 / moments[axis]);
    }
  }

  static constexpr std::align_val_t page{4096};
  struct Free {
    void operator()(Real* numbers) const { ::operator delete(numbers, page); }
  };
  std::size_t count_, stride_;
  std::unique_ptr<Real[], Free> numbers_;
};

}  // namespace tumble::support::bench
