/// @file
/// How bad input is refused: where it enters, with a sentence that names the value, its unit and
/// the rule.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tumble/real.hpp>

namespace tumble {

/// The shortest text that reads back as exactly `value`. What is no number is "nan": the sign that
/// a processor gives it means nothing, and libraries write it each in a way of their own.
template <class Real>
std::string text_of(Real value) {
  if constexpr (std::floating_point<Real>)
    if (std::isnan(value)) return "nan";
  char buffer[64] = {};  // to_chars writes no closing zero
  std::to_chars(buffer, buffer + sizeof buffer - 1, value);
  return buffer;
}

/// The pieces as one text. A long sum of strings says the same, and is slower to compile.
inline std::string joined(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text += piece;
  return text;
}

/// A vector as "(x, y, z)".
template <class Real>
std::string text_of(const Vec3<Real>& value) {
  return joined({"(", text_of(value.x()), ", ", text_of(value.y()), ", ", text_of(value.z()), ")"});
}

/// Throws std::invalid_argument with a sentence of the form "NAME is VALUE UNIT; RULE".
template <class Value>
[[noreturn]] void reject(std::string_view name, const Value& value, std::string_view unit,
                         std::string_view rule) {
  throw std::invalid_argument(
      joined({name, " is ", text_of(value), unit.empty() ? "" : " ", unit, "; ", rule}));
}

/// Throws unless `value` lies between `smallest` and `largest`, both of them allowed.
template <class Real>
void require_between(std::string_view name, Real value, std::string_view unit, Same<Real> smallest,
                     Same<Real> largest) {
  if (value >= smallest && value <= largest) return;
  reject(name, value, unit,
         joined({"it must lie between ", text_of(smallest), " and ", text_of(largest),
                 unit.empty() ? "" : " ", unit}));
}

/// Throws unless `value` is neither infinite nor NaN.
template <class Real>
void require_finite(std::string_view name, Real value, std::string_view unit) {
  if (!std::isfinite(value)) reject(name, value, unit, "it must be finite");
}

/// Throws unless `value` is 0 or more, and neither infinite nor NaN.
template <class Real>
void require_not_negative(std::string_view name, Real value, std::string_view unit) {
  require_finite(name, value, unit);
  if (value < 0) reject(name, value, unit, "it must be 0 or more");
}

/// True when every element of a vector or matrix is neither infinite nor NaN.
///
/// Eigen's allFinite() says the same, but costs the compiler a dozen types for each kind of matrix,
/// and every file of the course would pay for them.
template <class Real, int rows, int columns>
bool is_finite(const Eigen::Matrix<Real, rows, columns>& value) {
  for (Eigen::Index i = 0; i < value.size(); ++i)
    if (!std::isfinite(value.data()[i])) return false;
  return true;
}

/// Throws unless all three components are neither infinite nor NaN.
template <class Real>
void require_finite(std::string_view name, const Vec3<Real>& value, std::string_view unit) {
  if (!is_finite(value)) reject(name, value, unit, "every component must be finite");
}

}  // namespace tumble
