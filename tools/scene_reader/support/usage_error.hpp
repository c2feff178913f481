/// @file
/// What is asked for can't be done.
#pragma once

#include <stdexcept>

namespace tumble::support {

/// The command line is wrong, or asks of a scene what it doesn't allow.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tumble::support
