/// @file
/// Sets of the quantities that an effect reads and writes.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace tumble {

/// A set of quantities, combined from those below with `|`.
struct Quantities {
  unsigned bits = 0;

  constexpr bool has(Quantities other) const { return (bits & other.bits) == other.bits; }
  constexpr bool has_any(Quantities other) const { return (bits & other.bits) != 0; }
  friend constexpr Quantities operator|(Quantities a, Quantities b) { return {a.bits | b.bits}; }
  friend constexpr Quantities operator&(Quantities a, Quantities b) { return {a.bits & b.bits}; }
  friend constexpr Quantities operator-(Quantities a, Quantities b) { return {a.bits & ~b.bits}; }
  friend constexpr bool operator==(Quantities, Quantities) = default;
};

namespace quantity {
inline constexpr Quantities none{0}, time{1}, mass{2}, position{4}, velocity{8}, orientation{16},
    spin{32}, force{64}, torque{128};
// What an effect can read of a centre, of a top, and of both; the time is for all to read.
inline constexpr Quantities of_centre = time | mass | position | velocity;
inline constexpr Quantities of_top = time | orientation | spin;
inline constexpr Quantities of_body = of_centre | of_top;
// Where a body is, which way it faces, and how fast it moves and turns.
inline constexpr Quantities of_motion = position | velocity | orientation | spin;
}  // namespace quantity

/// "position, velocity"
inline std::string text_of(Quantities set) {
  constexpr std::array<std::string_view, 8> names = {"time",        "mass", "position", "velocity",
                                                     "orientation", "spin", "force",    "torque"};
  std::string text;
  for (unsigned i = 0; i < names.size(); ++i)
    if (set.has({1u << i})) text.append(text.empty() ? "" : ", ").append(names[i]);
  return text;
}

}  // namespace tumble
