/// @file
/// What stands in an exercise where code is still to be written.
#pragma once

#include <stdexcept>
#include <string>

namespace tumble::exercise {

/// Thrown by todo(): the verdict says "not written yet", and takes it for no wrong number.
struct NotWritten : std::logic_error {
  using std::logic_error::logic_error;
};

/// Put your own code here: `what` says what it shall do.
/// @throws NotWritten always.
[[noreturn]] inline void todo(const char* what) {
  throw NotWritten(what);
}

}  // namespace tumble::exercise

using tumble::exercise::todo;
