/// @file
/// A world stepped by its plan beside the same world stepped exhaustively.
#pragma once

#include <string>
#include <tumble/world.hpp>

namespace tumble::course {

/// Where two sets of bodies differ in the value of a number of their motion, as a sentence; empty if
/// they do not. A zero may differ in its sign, as 0 + v and v do.
template <class Real>
std::string difference_in_value(const Bodies<Real>& plan, const Bodies<Real>& other) {
  const auto said = [](std::size_t body, const char* what) {
    return "body " + std::to_string(body) + " differs in its " + what;
  };
  for (std::size_t i = 0; i < plan.centres.size(); ++i) {
    if (plan.centres[i].position != other.centres[i].position) return said(i, "position");
    if (plan.centres[i].velocity != other.centres[i].velocity) return said(i, "velocity");
  }
  for (std::size_t i = 0; i < plan.tops.size(); ++i) {
    const Top<Real>&a = plan.tops[i], &b = other.tops[i];
    if (a.angular_momentum_body != b.angular_momentum_body)
      return said(plan.body_of[i], "angular momentum");
    if (a.orientation.real != b.orientation.real ||
        a.orientation.imaginary != b.orientation.imaginary)
      return said(plan.body_of[i], "orientation");
  }
  return {};
}

}  // namespace tumble::course
