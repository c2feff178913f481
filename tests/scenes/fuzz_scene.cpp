// Whatever the text of a scene file is: it becomes a world whose plan, reference run and packs
// agree to the bit, or it is refused with the name of the file. Nothing else is allowed to happen.
// libFuzzer calls this with texts of its own making, and run_corpus.cpp with those in corpus/.
#include <support/complaint_of_step.hpp>
#include <support/random_world.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/scene/read_scene.hpp>

using namespace tumble;

namespace {

void require(bool fact) {
  if (!fact) std::abort();
}

template <class Real>
void load_and_step(std::string_view text) {
  try {
    World<Real> planned = read_scene<Real>(text, "fuzz.json", {.most_copies = 5}).world;
    World<Real> reference = planned;
    auto packed = read_scene<Real, InPacks<Real>>(text, "fuzz.json", {.most_copies = 5}).world;
    for (int step = 0; step < 3; ++step) {
      const std::string complaint = support::complaint_of_step([&] { planned.step(); });
      require(support::complaint_of_step([&] { reference.step_by_reference(); }) == complaint);
      require(support::complaint_of_step([&] { packed.step(); }) == complaint);
      require(support::same_motion(planned.bodies(), reference.bodies()));
      require(support::same_motion(planned.bodies(), packed.bodies()));
    }
    table_of(planned.plan());
  } catch (const SceneError& error) {
    require(std::string_view(error.what()).starts_with("fuzz.json: "));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  load_and_step<double>(text);
  load_and_step<float>(text);
  return 0;
}
