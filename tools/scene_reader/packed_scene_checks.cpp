#include <support/checks.hpp>
#include <support/random_world.hpp>
#include <support/shipped_scenes.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/scene/read_scene_file.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE(
    "Every shipped scene moves in packs as one by one, to the bit: 240 steps, or 20 where there "
    "are "
    "over ten thousand bodies",
    Real, EVERY_PRECISION) {
  for (const std::filesystem::path& path : shipped_scenes()) {
    CAPTURE(path.stem().string());
    World<Real> plain = read_scene_file<Real>(path).world;
    auto packed = read_scene_file<Real, InPacks<Real>>(path).world;
    packed.use_threads(2);
    const int steps = plain.body_count() > 10'000 ? 20 : 240;
    for (int n = 0; n < steps; ++n) {
      plain.step();
      packed.step();
    }
    CHECK(same_motion(plain.bodies(), packed.bodies()));
  }
}
