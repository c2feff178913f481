// Steps scenes in three ways, by plan, by reference and in packs, and by plan with the other
// schemes too, in both precisions, and prints a digest of every state: scene_bits SCENE.json...
#include "digest.hpp"

#include <filesystem>
#include <string>
#include <tumble/in_packs.hpp>
#include <tumble/scene/read_scene_file.hpp>

namespace {

using namespace tumble;

/// 2000 steps, or as many as make 200 000 steps of one body, but 20 at least.
template <class AnyWorld, class Step>
bits::Digest run(AnyWorld world, const Step& step) {
  bits::Digest digest;
  const int steps = std::clamp(200'000 / std::max(1, int(world.body_count())), 20, 2000);
  for (int n = 0; n < steps; ++n) {
    step(world);
    const auto& bodies = world.bodies();
    for (const auto& centre : bodies.centres) digest.take(centre);
    for (const auto& top : bodies.tops) digest.take(top);
  }
  return digest;
}

template <class Real>
void print_digests(const std::filesystem::path& path) {
  const std::string what = "scene " + path.stem().string();
  const auto plan = [](auto& world) { world.step(); };
  const auto scene = read_scene_file<Real>(path);
  bits::print<Real>(what, run(scene.world, plan));
  bits::print<Real>(what + ", by reference",
                    run(scene.world, [](auto& world) { world.step_by_reference(); }));
  for (const Scheme scheme : {Scheme::verlet, Scheme::suzuki}) {
    World<Real> world = scene.world;
    world.step_by(scheme);
    bits::print<Real>(what + " with " + std::string(name_of(scheme)), run(std::move(world), plan));
  }
  auto packed = read_scene_file<Real, InPacks<Real>>(path);
  packed.world.use_threads(1);
  bits::print<Real>(what + ", in packs", run(packed.world, plan));
}

}  // namespace

int main(int argument_count, char** arguments) try {
  for (int n = 1; n < argument_count; ++n) {
    print_digests<float>(arguments[n]);
    print_digests<double>(arguments[n]);
  }
} catch (const std::exception& refusal) {
  std::fprintf(stderr, "%s\n", refusal.what());
  return 1;
}
