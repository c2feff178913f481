#include <support/rungs.hpp>

template <>
std::span<const tumble::TurningRung<float>> tumble::support::rungs<float>() {
  return turning_ladder<float>;
}
