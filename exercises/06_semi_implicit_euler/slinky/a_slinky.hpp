/// @file
/// The numbers of the lab's slinky.
#pragma once

namespace tumble::support {

/// A slinky as a row of beads with a spring between each and the next.
struct Slinky {
  static constexpr int beads = 24;
  static constexpr double mass = 0.01;      ///< of a bead, kg
  static constexpr double stiffness = 25;   ///< of each spring, N/m
  static constexpr double closed = 0.0025;  ///< length of a spring that nothing pulls, m
  static constexpr double gravity = 9.81;   ///< downward, m/s²
};

}  // namespace tumble::support
