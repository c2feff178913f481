#include <support/checks.hpp>
#include <support/complaint_of_step.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

const PlanRow* row_of(const Plan& plan, std::string_view effect) {
  for (const PlanRow& row : plan.rows)
    if (row.effect == effect) return &row;
  return nullptr;
}

/// A text with every run of blanks made one.
std::string squeezed(const std::string& text) {
  std::string result;
  for (const char letter : text)
    if (letter != ' ' || result.empty() || result.back() != ' ') result += letter;
  return result;
}

/// A force that is no number after a tenth of a second.
template <class Real>
struct BrokenMotor {
  static constexpr std::string_view name = "broken motor";
  Vec3<Real> force(const Particle<Real>&, Real time) const {
    return {time < Real(0.1) ? Real(0) : std::numeric_limits<Real>::quiet_NaN(), 0, 0};
  }
};

template <class Real>
RigidBody<Real> box_body(const Vec3<Real>& spin = Vec3<Real>::Zero()) {
  return make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 2), {},
                               Vec3<Real>::Zero(), spin)
      .body;
}

}  // namespace

TEST_CASE_TEMPLATE("A thousand random worlds move by plan as by the reference run, to the bit",
                   Real, EVERY_PRECISION) {
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> planned = random_world<Real>(dice);
    World<Real> reference = planned;
    const Bodies<Real> start = planned.bodies();
    RandomGenerator planned_dice = dice, reference_dice = dice;
    for (int n = 0; n < 12; ++n) {
      if (n % 4 == 3) {
        meddle(planned, planned_dice, n);
        meddle(reference, reference_dice, n);
      }
      const std::string complaint = complaint_of_step([&] { planned.step(); });
      REQUIRE(complaint_of_step([&] { reference.step_by_reference(); }) == complaint);
      REQUIRE(same_motion(planned.bodies(), reference.bodies()));
    }
    moved += !same_motion(start, planned.bodies());
  }
  CHECK(moved > 800);  // the worlds are not idle: four in five have changed
}

TEST_CASE_TEMPLATE("A step that fails by plan fails by the reference run too, in the same words",
                   Real, EVERY_PRECISION) {
  int failed = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> planned = random_world<Real>(dice);
    planned.add(BrokenMotor<Real>{});
    World<Real> reference = planned;
    for (int n = 0; n < 12; ++n) {
      const Bodies<Real> before = planned.bodies();
      const std::string complaint = complaint_of_step([&] { planned.step(); });
      REQUIRE(complaint_of_step([&] { reference.step_by_reference(); }) == complaint);
      REQUIRE(same_motion(planned.bodies(), reference.bodies()));
      if (complaint.empty()) continue;
      REQUIRE(same_motion(planned.bodies(), before));
      ++failed;
      break;
    }
  }
  CHECK(failed > 50);  // wherever a body is not static
}

TEST_CASE_TEMPLATE("A first spin changes the plan at once, and the world says so", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle box = world.add("box", box_body<Real>());
  CHECK(row_of(world.plan(), "tumbling: splitting")->visited == 0);
  CHECK(row_of(world.plan(), "tumbling: splitting")->reason ==
        "not 1: no spin and nothing that can give torque");
  CHECK(world.change_log().empty());
  for (int n = 0; n < 3; ++n) world.step();
  world.set_angular_velocity(box, {0, 1, 0});
  CHECK(row_of(world.plan(), "tumbling: splitting")->visited == 1);
  REQUIRE(world.change_log().size() == 1);
  CHECK(world.change_log()[0] ==
        "step 3: tumbling: splitting visits 1 of 1, before 0 ('box' got its first spin)");
  const Quaternion<Real> before = world.orientation(box);
  world.step();
  CHECK_FALSE(same_bits(world.orientation(box).imaginary, before.imaginary));
}

TEST_CASE("A plan prints as a table, with a reason in every line") {
  World<double> world;
  for (int n = 0; n < 3; ++n)
    world.add("ball " + std::to_string(n),
              make_rigid_body<double>("ball", mass_properties(Sphere<double>{1}, 2), {},
                                      Vec3d::Zero(), {0, 0, 1})
                  .body);
  world.add("box", box_body<double>({0, 0, 1}));
  world.add(Gravity<double>{});
  const std::string table = squeezed(table_of(world.plan()));
  CHECK(table.find("\ngravity force 4 of 4 mass force every body calls for it\n") !=
        std::string::npos);
  CHECK(table.find("\ntumbling: splitting drift 1 of 4 ") != std::string::npos);
  CHECK(table.find("not 3: equal moments or a locked axis: they turn steadily\n") !=
        std::string::npos);
  CHECK(table.find("\nkick of the spin no pass 0 of 4 ") != std::string::npos);
  for (const Plan plan = world.plan(); const PlanRow& row : plan.rows) {
    CAPTURE(row.effect);
    CHECK(!row.reason.empty());
  }
}
