#include <support/checks.hpp>
#include <support/random_boxes.hpp>
#include <support/scene_rules.hpp>
#include <tumble/in_packs.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("By every rung that a scene can name, packs turn as one by one, to the bit",
                   Real, EVERY_PRECISION) {
  for (std::size_t rung = first_rung; rung < SceneRules::names.size(); ++rung) {
    CAPTURE(SceneRules::names[rung]);
    World<Real> plain(steps_per_second(10));
    ManyBodies<Real> packed(steps_per_second(10));
    SceneRules::choose(plain, rung);
    SceneRules::choose(packed, rung);
    add_boxes(plain, 37);
    add_boxes(packed, 37);
    for (int step = 0; step < 20; ++step) {
      plain.step();
      packed.step();
    }
    CHECK(same_motion(plain.bodies(), packed.bodies()));
  }
}
