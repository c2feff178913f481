/// @file
/// How much a line of the books amounts to.
#pragma once

#include <tumble/ledger.hpp>

namespace tumble::support {

/// The sizes of its energy and of both its momenta, added up: 0 if there is nothing in it.
inline double size_of(const LedgerLine& line) {
  return std::abs(line.energy) + line.momentum.norm() + line.angular_momentum.norm();
}

}  // namespace tumble::support
