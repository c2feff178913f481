// The same function on one top and on a pack of them; then a whole world, kept in three ways.
#include <support/random_world.hpp>
#include <support/record.hpp>
#include <tumble/in_packs.hpp>

using namespace tumble;

namespace {

constexpr int width = natural_width<float>;
using Packed = Pack<float, width>;

/// A top with moments near 1, 1/2 and 1/3, no two alike.
Top<float> top_number(int n) {
  Top<float> top;
  top.inverse_moments = {3, 2, 1 + 0.01f * float(n)};
  top.angular_momentum_body = {0.1f * float(n), 1, 0.2f};
  return top;
}

//! [turn]
template <class Real>
void turn_for_a_second(Top<Real>& top) {
  for (int step = 0; step < 60; ++step) turn_by_splitting(top, 1.0f / 60);
}
//! [turn]

/// `count` tumbling boxes with the effects of the benchmark's fullest scene: gravity, a torque and
/// damping of both kinds.
template <class AnyWorld>
AnyWorld falling_boxes(int count) {
  support::RandomGenerator dice(12);
  AnyWorld world(steps_per_second(60));
  const auto box = mass_properties(Box<float>{{0.1f, 0.2f, 0.3f}}, 2);
  for (int n = 0; n < count; ++n)
    world.add("box " + std::to_string(n),
              make_rigid_body<float>("box", box, {{0, 0, 100}}, dice.vector<float>(),
                                     5 * dice.vector<float>())
                  .body);
  world.add(Gravity<float>{});
  world.add(support::SteadyTorque<float>{{0, 0, 1e-4f}});
  world.add(LinearDamping<float>{.rate = 0.1f});
  world.add(AngularDamping<float>{.rate = 0.1f});
  return world;
}

template <class AnyWorld>
Bodies<float> after_a_minute(AnyWorld world) {
  for (int step = 0; step < 3600; ++step) world.step();
  return world.bodies();
}

/// What the figure draws: drops that fall for a tenth of a second, all by one addition.
void write_drops(const support::Notebook& notebook) {
  using Eight = Pack<float, 8>;
  const Eight::Lanes heights = {2.9f, 1.4f, 3.6f, 2.2f, 3.1f, 1.8f, 2.5f, 1.1f};  // m
  const Eight::Lanes speeds = {-5, -7, -4, -8, -6, -5, -9, -4};                   // m/s
  const Eight z = heights, change = Eight(0.1f) * Eight(speeds), next = z + change;
  support::Table table = notebook.table("drops", {"lane", "z (m)", "change (m)", "next (m)"});
  for (int lane = 0; lane < 8; ++lane) table.row(double(lane), z[lane], change[lane], next[lane]);
}

/// What a second figure draws: eight balls, two of which are in soft ground, and the pushes between
/// which a mask chooses.
void write_select(const support::Notebook& notebook) {
  using Eight = Pack<float, 8>;
  const Eight::Lanes heights = {0.12f, -0.01f, 0.05f, 0.3f, -0.03f, 0.08f, 0.21f, 0.02f};  // m
  const Eight z = heights, stiffness = 1000.0f;                                            // N/m
  //! [select]
  const auto is_below = z < 0;
  const Eight if_below = -stiffness * z;
  const Eight push = select(is_below, if_below, Eight(0));
  //! [select]
  support::Table table =
      notebook.table("select", {"lane", "z (m)", "is below", "if below (N)", "push (N)"});
  for (int lane = 0; lane < 8; ++lane)
    table.row(double(lane), z[lane], double(is_below[lane]), if_below[lane], push[lane]);
}

/// What another figure draws: which packs of points and bodies may be visited at the same time, and
/// where their tops lie.
void write_colouring(const support::Notebook& notebook) {
  constexpr int lanes = 4;
  Bodies<float> bodies;
  IndexSet all;
  const Top<float> top;
  for (const char kind : std::string_view("BBoBBBBBoBBooBBB"))
    all.insert(append(bodies, Particle<float>{}, kind == 'B' ? &top : nullptr));
  const PackColouring parts =
      pack_colouring(packed_index_set<float, lanes>(all), packed<float, lanes>(bodies));
  support::Table table = notebook.table("colouring", {"body", "part", "top"});
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (const std::uint32_t pack : parts[part])
      for (BodyIndex body = pack * lanes; body < (pack + 1) * lanes; ++body)
        table.row(double(body), double(part),
                  is_point(bodies, body) ? -1. : double(bodies.top_of[body]));
  support::expect(parts.size() == 2, "two parts keep these packs apart");
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);

  write_drops(notebook);
  write_select(notebook);
  write_colouring(notebook);
  Top<Packed> pack;
  for (int lane = 0; lane < width; ++lane) set_lane(pack, lane, top_number(lane));
  turn_for_a_second(pack);
  std::printf("Angular momentum along the body's x after a second, kg m^2/s\n");
  std::printf("  lane   in a pack    alone\n");
  for (int lane = 0; lane < width; ++lane) {
    Top<float> alone = top_number(lane);
    turn_for_a_second(alone);
    const float packed_x = pack.angular_momentum_body.x()[lane];
    if (lane < 4)  // of the others it is only checked
      std::printf("  %4d  %10.7f  %10.7f\n", lane, double(packed_x),
                  double(alone.angular_momentum_body.x()));
    support::expect(packed_x == alone.angular_momentum_body.x(), "a lane has the bits of one body");
  }

  //! [use]
  auto world = falling_boxes<ManyBodies<float>>(2000);  // ManyBodies in place of World
  world.use_threads(2);
  //! [use]
  //! [three_worlds]
  const Bodies<float> one_by_one = after_a_minute(falling_boxes<World<float>>(2000));
  const Bodies<float> in_packs = after_a_minute(falling_boxes<ManyBodies<float>>(2000));
  const Bodies<float> on_two_threads = after_a_minute(world);
  //! [three_worlds]
  const bool same = support::same_motion(one_by_one, in_packs) &&
                    support::same_motion(one_by_one, on_two_threads);
  std::printf(
      "\nTwo thousand boxes after a minute, one by one, in packs, and on two threads:\n"
      "%s bit of their motion differs.\n",
      same ? "no" : "some");
  support::expect(same, "the three worlds agree to the bit");

  notebook.value("smallest_share", std::to_string(InPacks<float>::smallest_share));
  notebook.value("smallest_share_of_pairs",
                 std::to_string(OnBoth<float, width>::smallest_share_of_pairs));
  notebook.value("passes", std::to_string(world.plan().passes()));
  notebook.value("width", std::to_string(width));
  notebook.value("width_double", std::to_string(natural_width<double>));
  notebook.value("bytes_point", std::to_string(sizeof(Particle<Packed>) / width));
  notebook.value("bytes_body",
                 std::to_string((sizeof(Particle<Packed>) + sizeof(Top<Packed>)) / width));
}
