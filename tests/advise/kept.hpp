/// @file
/// What the two halves of promise_kept share. Scenes are compiled apart, each precision by itself.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <tumble/top.hpp>

using namespace tumble;
using Json = nlohmann::json;

[[noreturn]] inline void fail(const std::string& sentence) {
  std::fprintf(stderr, "error: %s\n", sentence.c_str());
  std::exit(EXIT_FAILURE);
}

template <class Real>
Top<long double> wide(const Top<Real>& top) {
  return {.orientation = normalized(Quaternion<long double>{
              top.orientation.real, top.orientation.imaginary.template cast<long double>()}),
          .angular_momentum_body = top.angular_momentum_body.template cast<long double>(),
          .inverse_moments = top.inverse_moments.template cast<long double>()};
}

/// Two scenes have exact solutions: a free top, and a planet around a star. The worst error of a
/// state on the way; for float and for double.
template <class Real>
double scene_error(const Json& question, const Json& promise);
