// What another project may count on with tumble::tumble, tumble::exact and tumble::scene.
#include <cmath>
#include <numbers>
#include <tumble/exact/oscillator.hpp>
#ifdef HAS_SCENES
#include <tumble/scene/read_scene.hpp>
#endif

namespace {

/// Whether a product and a sum round one after the other, as the library's target asks of every
/// user's compiler. A fused operation would keep the last term of (1 + e)² = 1 + 2e + e².
bool rounds_twice() {
  volatile double given = 1 + 0x1p-30;
  const double factor = given;
  const double rounded = 1 + 0x1p-29;
  return factor * factor - rounded == 0;
}

/// What lies beside the library: an oscillator without damping is at its start again after a
/// period.
bool has_exact_solutions() {
  const tumble::exact::Oscillator<double> oscillator({.position = 1}, 1, 0);
  return std::abs(oscillator.at(2 * std::numbers::pi).position - 1) < 1e-15;
}

bool reads_scenes() {
#ifdef HAS_SCENES
  const char* const text = R"({"duration": 1, "step": {"per_second": 60}, "bodies": [
    {"name": "ball", "mass": 1}]})";
  return tumble::read_scene<double>(text, "a text").world.body_count() == 1;
#else
  return true;
#endif
}

}  // namespace

int main() {
  return rounds_twice() && has_exact_solutions() && reads_scenes() ? 0 : 1;
}
