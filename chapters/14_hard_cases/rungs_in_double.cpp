#include <course/rungs.hpp>

template <>
std::span<const tumble::TurningRung<double>> tumble::course::rungs<double>() {
  return turning_ladder<double>;
}
