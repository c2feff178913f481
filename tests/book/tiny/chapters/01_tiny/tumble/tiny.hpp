/// @file
/// One number, for a book of one chapter.
#pragma once

namespace tumble {

//! [length]
/// The length of a stick in metres.
constexpr double stick_length() {
  return 1.25;
}
//! [length]

//! [nothing]
//! [nothing]

}  // namespace tumble
