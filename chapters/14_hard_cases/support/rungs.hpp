/// @file
/// The turning ladder, compiled once for all checks and programs of the chapter.
#pragma once

#include <span>
#include <string_view>
#include <tumble/ladder.hpp>

namespace tumble::support {

/// All rungs of turning_ladder<Real>, for float and double.
template <class Real>
std::span<const TurningRung<Real>> rungs();
template <>
std::span<const TurningRung<float>> rungs<float>();
template <>
std::span<const TurningRung<double>> rungs<double>();

/// The most turns that a rung makes in one step: those of the longest row, and the sphere's.
inline constexpr std::size_t most_turns =
    SofroniouSpaletta::row.kicks.size() + SofroniouSpaletta::row.drifts.size() + 1;

/// The rung of that name. @throws std::invalid_argument if there is none.
template <class Real>
const TurningRung<Real>& rung_called(std::string_view name) {
  for (const TurningRung<Real>& rung : rungs<Real>())
    if (rung.name == name) return rung;
  throw std::invalid_argument("no rung is called '" + std::string(name) + "'");
}

}  // namespace tumble::support
