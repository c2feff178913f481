/// @file
/// A top in long double, for whoever watches one in float or double.
#pragma once

#include <tumble/top.hpp>

namespace tumble::support {

/// The same numbers in long double: truth starts from the rounded values.
template <class Real>
Top<long double> exactly(const Top<Real>& top) {
  return {.orientation = normalized(Quaternion<long double>{
              top.orientation.real, top.orientation.imaginary.template cast<long double>()}),
          .angular_momentum_body = top.angular_momentum_body.template cast<long double>(),
          .torque = top.torque.template cast<long double>(),
          .inverse_moments = top.inverse_moments.template cast<long double>()};
}

}  // namespace tumble::support
