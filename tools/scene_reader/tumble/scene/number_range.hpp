/// @file
/// Which numbers a scene file may hold, for each precision of its world.
#pragma once

#include <limits>
#include <string_view>

namespace tumble {

/// Which numbers can be stored.
struct NumberRange {
  std::string_view precision;
  double smallest, largest;  ///< other than 0, and in size
  double largest_component;  ///< of a vector, so that its square is a number too
};

template <class Real>
constexpr NumberRange range_of() {
  using Limits = std::numeric_limits<Real>;
  constexpr bool is_float = Limits::digits < 53;
  return {is_float ? "float" : "double", static_cast<double>(Limits::min()),
          static_cast<double>(Limits::max()), is_float ? 1e18 : 1e150};
}

}  // namespace tumble
