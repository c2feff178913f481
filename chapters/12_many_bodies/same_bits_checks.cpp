#include <course/checks.hpp>
#include <course/random_world.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/ledger.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

/// Steps, and says why not if that could not be done.
template <class AnyWorld>
std::string complaint_of_step(AnyWorld& world) {
  try {
    world.step();
  } catch (const SimulationError& error) {
    return error.what();
  }
  return {};
}

/// Random worlds with up to 40 bodies, kept in packs of `width` and stepped by `threads`, beside
/// the same worlds with their bodies one by one.
template <class Real, int width>
void compare_with_one_by_one(std::uint64_t first_seed, int count, int threads) {
  int moved = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + static_cast<std::uint64_t>(count);
       ++seed) {
    CAPTURE(seed);
    CAPTURE(width);
    CAPTURE(threads);
    Dice dice(seed), same_dice(seed);
    World<Real> plain = random_world<Real>(dice, 40);
    auto packed = random_world<Real, InPacks<Real, width>>(same_dice, 40);
    packed.keeping().use_threads(threads);
    const Bodies<Real> start = plain.bodies();
    for (int n = 0; n < 16; ++n) {
      if (n % 4 == 3) {
        meddle(plain, dice, n);
        meddle(packed, same_dice, n);
      }
      const std::string complaint = complaint_of_step(plain);
      REQUIRE(complaint_of_step(packed) == complaint);
      REQUIRE(same_motion(plain.bodies(), packed.bodies()));
    }
    moved += !same_motion(start, plain.bodies());
  }
  CHECK(moved > count / 2);
}

/// A wind of the user's own, who wrote it for one body and never heard of packs. From its hour on
/// it is infinite.
template <class Real>
struct Wind {
  static constexpr std::string_view name = "wind";
  Real hour = 0;  ///< s
  Vec3<Real> force(const Particle<Real>& centre, Real time) const {
    if (time >= hour) return {std::numeric_limits<Real>::infinity(), 0, 0};
    return {centre.position.y(), 0, std::sin(centre.position.x())};
  }
};

}  // namespace

//! [same_bits]
TEST_CASE_TEMPLATE("Random worlds move in packs as one by one, to the bit", Real, EVERY_PRECISION) {
  compare_with_one_by_one<Real, natural_width<Real>>(1, 100, 1);
}
//! [same_bits]

TEST_CASE_TEMPLATE("The width of the packs and the number of threads change no bit", Real,
                   EVERY_PRECISION) {
  compare_with_one_by_one<Real, 2>(1001, 40, 2);
  compare_with_one_by_one<Real, 32 / sizeof(Real)>(1041, 40, 3);
}

//! [taken_back]
TEST_CASE_TEMPLATE("A step in packs that fails is taken back to the bit, with the same error", Real,
                   EVERY_PRECISION) {
  // 1.5 s are 96 steps: one and a half times as many as can be repeated without another copy.
  Dice dice(5), same_dice(5);
  World<Real> plain(steps_per_second(64));
  World<Real, InPacks<Real>> packed(steps_per_second(64));
  for (int n = 0; n < 21; ++n) {
    add_random_body(plain, dice, "body " + std::to_string(n));
    add_random_body(packed, same_dice, "body " + std::to_string(n));
  }
  const BodyHandle last = plain.add("kite", make_particle<Real>(1, {1, 2, 3}));
  packed.add("kite", make_particle<Real>(1, {1, 2, 3}));
  plain.add(Wind<Real>{Real(1.5)}, {last});
  packed.add(Wind<Real>{Real(1.5)}, {packed.find("kite")});
  for (int n = 0; n < 96; ++n) {
    if (n == 50 || n == 70 || n == 95) {  // before the last copy, after it, and at the end
      plain.set_velocity(last, {Real(n), 0, 0});
      packed.set_velocity(packed.find("kite"), {Real(n), 0, 0});
    }
    plain.step();
    packed.step();
  }
  for (int again = 0; again < 2; ++again) {
    const std::string complaint = complaint_of_step(plain);
    CHECK(complaint.find("wind gives a force of (inf, 0, 0) N") != std::string::npos);
    CHECK(complaint_of_step(packed) == complaint);
    CHECK(packed.ticks() == 96);
    CHECK(same_motion(plain.bodies(), packed.bodies()));
  }
}
//! [taken_back]

TEST_CASE_TEMPLATE("The books of a world in packs are those of one body after another", Real,
                   EVERY_PRECISION) {
  Dice dice(77), same_dice(77);
  World<Real> plain = random_world<Real>(dice, 40);
  auto packed = random_world<Real, InPacks<Real>>(same_dice, 40);
  Ledger<Real> books(plain), packed_books(packed);
  for (int n = 0; n < 10; ++n) {
    books.step(plain);
    packed_books.step(packed);
  }
  CHECK(same_motion(plain.bodies(), packed.bodies()));
  CHECK(table_of(books, plain) == table_of(packed_books, packed));
}

TEST_CASE("A world of points in packs keeps no tops") {
  ManyBodies<float> rain;
  for (int n = 0; n < 20; ++n) rain.add(std::to_string(n), make_particle<float>(1));
  rain.add(GravityAsAcceleration<float>{});
  rain.step();
  CHECK(rain.top_count() == 0);
  CHECK(rain.body_count() == 20);
}

TEST_CASE_TEMPLATE("Thousands of bodies shared among threads move as one by one, to the bit", Real,
                   EVERY_PRECISION) {
  const auto crowd = []<class AnyWorld>(AnyWorld world) {
    Dice dice(2000);
    std::vector<BodyHandle> bodies;
    for (int n = 0; n < 3001; ++n)
      bodies.push_back(add_random_body(world, dice, "body " + std::to_string(n)));
    world.add(Gravity<Real>{});
    world.add(AngularDamping<Real>{.rate = Real(0.1)});
    world.add(Magnus<Real>{.strength = Real(0.01), .wind = {1, 0, 0}});
    for (int n = 0; n < 20; ++n) add_random_effect(world, dice, {bodies[dice.below(3001)]});
    return world;
  };
  World<Real> plain = crowd(World<Real>(steps_per_second(60)));
  for (int step = 0; step < 10; ++step) plain.step();
  for (const int threads : {2, 3, 5}) {
    CAPTURE(threads);
    auto packed = crowd(World<Real, InPacks<Real>>(steps_per_second(60)));
    packed.keeping().use_threads(threads);
    for (int step = 0; step < 10; ++step) packed.step();
    CHECK(same_motion(plain.bodies(), packed.bodies()));
  }
}

TEST_CASE_TEMPLATE("A body that fills a gap in a pack keeps its own top", Real, EVERY_PRECISION) {
  // The gap is the second place of the second pack: the last body's top, which lies a pack further
  // on, then belongs between two that lie side by side.
  constexpr int width = natural_width<Real>;
  const auto flown = []<class AnyWorld>(AnyWorld world) {
    const auto ball = mass_properties(Sphere<Real>{1}, 1);
    for (int n = 0; n <= 2 * width; ++n)
      if (n == width + 1)
        world.add("gap", make_particle<Real>(1));
      else
        world.add("ball " + std::to_string(n),
                  make_rigid_body<Real>("ball", ball, {}, {1, 0, 0}, {0, 0, Real(n)}).body);
    world.add(Magnus<Real>{.strength = Real(0.1)});
    world.remove(world.find("gap"));
    for (int step = 0; step < 4; ++step) world.step();
    return world.bodies();
  };
  CHECK(same_motion(flown(World<Real>()), flown(ManyBodies<Real>())));
}
