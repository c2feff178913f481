#include <support/rungs.hpp>

template <>
std::span<const tumble::TurningRung<double>> tumble::support::rungs<double>() {
  return turning_ladder<double>;
}
