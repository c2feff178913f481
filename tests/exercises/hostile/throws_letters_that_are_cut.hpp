// earns: 1
// because: a€€
#pragma once
#include <stdexcept>
#include <string>

template <class Real>
Real doubled(Real number) {
  std::string long_one = "a";
  while (long_one.size() < 5000) long_one += "\xe2\x82\xac";
  throw std::runtime_error(long_one);
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
