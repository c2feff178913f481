/// @file
/// How bad input is refused: where it enters, with a sentence that names the value, its unit and
/// the rule.
#pragma once

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tumble/real.hpp>

namespace tumble {

/// The shortest text that reads back as exactly `value`.
template <class Real>
std::string text_of(Real value) {
  char buffer[64] = {};  // to_chars writes no closing zero
  std::to_chars(buffer, buffer + sizeof buffer - 1, value);
  return buffer;
}

/// A vector as "(x, y, z)".
template <class Real>
std::string text_of(const Vec3<Real>& value) {
  std::string text = "(";
  text += text_of(value.x()) + ", " + text_of(value.y()) + ", " + text_of(value.z()) + ")";
  return text;
}

/// Throws std::invalid_argument with a sentence of the form "NAME is VALUE UNIT; RULE".
template <class Value>
[[noreturn]] void reject(std::string_view name, const Value& value, std::string_view unit,
                         std::string_view rule) {
  std::string sentence = std::string(name) + " is " + text_of(value);
  if (!unit.empty()) sentence += " " + std::string(unit);
  throw std::invalid_argument(sentence + "; " + std::string(rule));
}

/// Throws unless `value` is neither infinite nor NaN.
template <class Real>
void require_finite(std::string_view name, Real value, std::string_view unit) {
  if (!std::isfinite(value)) reject(name, value, unit, "it must be finite");
}

/// Throws unless all three components are neither infinite nor NaN.
template <class Real>
void require_finite(std::string_view name, const Vec3<Real>& value, std::string_view unit) {
  if (!value.allFinite()) reject(name, value, unit, "every component must be finite");
}

}  // namespace tumble
