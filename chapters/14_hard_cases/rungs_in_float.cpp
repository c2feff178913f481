#include <course/rungs.hpp>

template <>
std::span<const tumble::TurningRung<float>> tumble::course::rungs<float>() {
  return turning_ladder<float>;
}
