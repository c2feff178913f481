/// @file
/// A π with all the digits of its kind.
#pragma once

namespace tumble::exact {

/// π. In libc++ (19 and before) std::numbers::pi_v<long double> has the digits of a double, which
/// is too few where a long double judges a double.
template <class Real>
constexpr Real pi = static_cast<Real>(3.14159265358979323846264338327950288L);

}  // namespace tumble::exact
