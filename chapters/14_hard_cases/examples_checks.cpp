// How the library is used, header by header: the reference shows each of these beside the header
// whose name it bears, and each is run.
#include <doctest/doctest.h>

#include <map>
#include <numbers>
#include <sstream>
#include <tumble/adaptive_ladder.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/drag.hpp>
#include <tumble/drawing.hpp>
#include <tumble/energy.hpp>
#include <tumble/exact/free_top.hpp>
#include <tumble/exact/kepler.hpp>
#include <tumble/gravity.hpp>
#include <tumble/gyroscope.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/interpolation.hpp>
#include <tumble/ledger.hpp>
#include <tumble/mesh_mass_properties.hpp>
#include <tumble/orientation.hpp>
#include <tumble/reaction_wheel.hpp>
#include <tumble/reduced_steps.hpp>
#include <tumble/snapshot_file.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/turning_rungs.hpp>

using namespace tumble;

TEST_CASE("A particle is pushed and takes a step") {
  //! [particle.hpp force.hpp]
  Particle<double> stone = make_particle(2.0, {0, 0, 10});  // kg; m
  add_gravity(stone, {0, 0, -9.81});                        // m/s²
  add_force(stone, {1, 0, 0});                              // N
  step(stone, 0.5);                                         // s
  CHECK(stone.velocity == Vec3d(0.25, 0, -4.905));          // m/s
  //! [particle.hpp force.hpp]
}

TEST_CASE("Two forces on a wrench are taken about another point") {
  //! [torque.hpp]
  Wrench<double> wrench;                          // about the origin
  add_force_at(wrench, {0, 0, 10}, {2, 0, 0});    // N, at m
  add_force_at(wrench, {0, 0, -10}, {-2, 0, 0});  // together a couple
  CHECK(wrench.force == Vec3d(0, 0, 0));
  CHECK(wrench.torque == Vec3d(0, -40, 0));  // N m
  CHECK(taken_about(wrench, {7, 8, 9}).torque == wrench.torque);
  //! [torque.hpp]
}

TEST_CASE("A hammer is put together from two solids") {
  //! [solids.hpp mass_properties.hpp]
  const auto handle = mass_properties(Cylinder<double>{0.02, 0.4}, 0.5);  // radius, height: m; kg
  const auto head = mass_properties(Box<double>{{0.12, 0.04, 0.04}}, 1.5);
  const auto hammer = combined<double>({handle, moved(head, Mat3d::Identity(), {0, 0, 0.2})});
  CHECK(hammer.mass == 2);
  CHECK(std::abs(hammer.centre_of_mass.z() - 0.15) < 1e-12);  // m
  //! [solids.hpp mass_properties.hpp]
}

TEST_CASE("A mesh has the mass properties of what it encloses") {
  //! [mesh.hpp mesh_mass_properties.hpp]
  const Mesh<double> wedge{.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}},  // m
                           .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  CHECK(std::abs(volume(wedge) - 1) < 1e-12);               // m³
  const auto solid = mass_properties(wedge, 8.0);           // kg; throws unless it is closed
  const Vec3d centre = solid.centre_of_mass;                // the mean of the corners
  CHECK((centre - Vec3d(0.75, 0.5, 0.25)).norm() < 1e-12);  // m
  //! [mesh.hpp mesh_mass_properties.hpp]
}

TEST_CASE("Orientations turn vectors, and follow one another") {
  //! [quaternion.hpp rotation_vector.hpp rotation_matrix.hpp]
  const auto up = quaternion_about<double>({0, -1, 0}, 0.3);  // axis; rad
  const auto left = quaternion_about<double>({0, 0, 1}, 1.2);
  const Quaternion<double> both = left * up;  // first up, then left
  const Vec3d arrow = rotate(both, {1, 0, 0});
  CHECK((arrow - matrix_of(both) * Vec3d(1, 0, 0)).norm() < 1e-12);
  CHECK(std::abs(angle_between(left, both) - 0.3) < 1e-12);  // rad
  CHECK((rotate_back(both, arrow) - Vec3d(1, 0, 0)).norm() < 1e-12);
  //! [quaternion.hpp rotation_vector.hpp rotation_matrix.hpp]
}

TEST_CASE("An orientation is turned by a steady angular velocity") {
  //! [orientation.hpp]
  Quaternion<double> q;                   // as it was made
  q = turn_exponential(q, {0, 0, 2}, 3);  // rad/s, world axes; s: as one turn of 6 rad
  for (int n = 0; n < 300; ++n) q = turn_exponential(q, {0, 0, 2}, 0.01);
  CHECK(angle_between(q, quaternion_about<double>({0, 0, 1}, 12)) < 1e-12);  // rad
  //! [orientation.hpp]
}

TEST_CASE("A rigid body is made from a solid, thrown and drawn") {
  //! [make_rigid_body.hpp rigid_body.hpp tumbling.hpp pose.hpp]
  const auto solid = mass_properties(Box<double>{{0.1, 0.2, 0.3}}, 2.0);  // m; kg
  const Pose<double> at{.position = {0, 0, 1}};                           // of the model, m
  auto [body, model_in_body] = make_rigid_body("box", solid, at, Vec3d(3, 0, 4), Vec3d(0, 5, 0));
  for (int n = 0; n < 60; ++n) {
    add_force(body, Vec3d(0, 0, -9.81) * mass_of(body.centre));  // N
    kick(body, 1.0 / 60);                                        // s
    drift(body, 1.0 / 60);
    clear_forces(body);
  }
  const Pose<double> drawn = drawn_pose(body, model_in_body);  // where to draw the model
  CHECK(std::abs(drawn.position.x() - 3) < 1e-12);             // m
  //! [make_rigid_body.hpp rigid_body.hpp tumbling.hpp pose.hpp]
}

TEST_CASE("A top is set spinning and given a torque") {
  //! [top.hpp]
  Top<double> top{.inverse_moments = {2, 2, 1}};          // 1/(kg m²), about the principal axes
  set_angular_velocity_world(top, {0, 0, 30});            // rad/s
  CHECK(angular_momentum_world(top) == Vec3d(0, 0, 30));  // kg m²/s
  CHECK(kinetic_energy(top) == 450);                      // J
  add_torque(top, {0.5, 0, 0});                           // N m, until clear_torque()
  //! [top.hpp]
  CHECK(top.torque.x() == 0.5);
}

TEST_CASE("A body is slowed by damping and by the air") {
  //! [damping.hpp drag.hpp]
  Particle<double> ball = make_particle(0.4, {0, 0, 0}, {20, 0, 0});  // kg, m, m/s
  damp(ball, fraction_kept(0.1, 1.0 / 60));                           // 1/s; a step, s
  CHECK(ball.velocity.x() < 20);
  const double coefficient = drag_coefficient(1.2, 0.47, 0.04);  // kg/m³; of a ball; m²
  add_force(ball, quadratic_drag(coefficient, ball.velocity, {0, 0, 0}));
  CHECK(ball.force.x() < 0);  // N, against the way it flies
  //! [damping.hpp drag.hpp]
}

TEST_CASE("A clock says how many steps a frame needs, and where between two of them it falls") {
  //! [step_clock.hpp interpolation.hpp]
  StepClock clock = make_step_clock(steps_per_second(60));
  Pose<double> before, now;
  for (std::int64_t n = steps_due(clock, nanoseconds_of(0.025)); n > 0; --n) {
    before = now;
    now.position.x() += 0.1;  // in place of a step
  }
  CHECK(clock.steps == 1);  // 0.025 s are one and a half steps
  const Pose<double> drawn = interpolated(before, now, fraction_of_step<double>(clock));
  CHECK(std::abs(drawn.position.x() - 0.05) < 1e-6);
  //! [step_clock.hpp interpolation.hpp]
}

TEST_CASE("A world is made, stepped, pushed and asked") {
  //! [world.hpp]
  World<double> world(steps_per_second(120));
  const auto solid = mass_properties(Sphere<double>{0.1}, 1.0);  // m; kg
  const BodyHandle ball = world.add("ball", make_rigid_body("ball", solid).body);
  const EffectHandle falling = world.add(Gravity<double>{});
  world.push_at(ball, {0, 0, 600}, {0, 0, 0});  // N at m, in the next step alone
  for (int n = 0; n < 120; ++n) world.step();
  CHECK(world.velocity(ball).z() < 0);  // 5 m/s up, and a second later back
  world.remove(falling);
  for (const PlanRow& row : world.plan().rows) CHECK(row.effect != "gravity");
  //! [world.hpp]
}

//! [forms.hpp effect_members.hpp terms.hpp]
/// Wind that is stronger higher up, and that drags whatever moves through it.
struct Wind {
  static constexpr std::string_view name = "wind";
  static constexpr Quantities reads = quantity::position | quantity::velocity;
  double drag = 0.2;  // N s/m

  Vec3d force(const Particle<double>& centre, double /*time*/) const {
    const Vec3d wind(0.5 * centre.position.z(), 0, 0);  // m/s
    return drag * (wind - centre.velocity);             // N
  }
  // What follows may be left out.
  void check() const { require_not_negative("drag of the wind", drag, "N s/m"); }
  std::string_view skip_reason(const BodyFlags&) const { return drag == 0 ? "no wind" : ""; }
  Response<double> response(const BodyState<double>&) const { return {.damping = drag}; }
};

TEST_CASE("An effect of one's own carries a leaf along") {
  World<double> world(steps_per_second(60));
  const BodyHandle leaf = world.add("leaf", make_particle(0.01, {0, 0, 4}));  // kg; m
  world.add(Wind{});
  CHECK(std::abs(world.step_limit().time_step - 0.1) < 1e-9);  // s, by its response: 2 m/c
  for (int n = 0; n < 60; ++n) world.step();
  CHECK(std::abs(world.velocity(leaf).x() - 2) < 1e-6);  // m/s, as fast as the wind
}
//! [forms.hpp effect_members.hpp terms.hpp]

//! [energy.hpp]
/// A valley along x, whose sides lead whatever slides on them back to its middle.
struct Valley {
  static constexpr std::string_view name = "valley";
  static constexpr Quantities reads = quantity::position;
  double stiffness = 2;  // N/m

  Vec3d force(const Particle<double>& centre, double /*time*/) const {
    return {0, -stiffness * centre.position.y(), 0};
  }
  double potential_energy(const BodyState<double>& body) const {
    const double y = body.centre.position.y();
    return stiffness * y * y / 2;  // J
  }
};

TEST_CASE("An effect of one's own stores energy, and gives it back") {
  World<double> world(steps_per_second(1000));
  world.add("sledge", make_particle(1.0, {0, 3, 0}));  // kg; m
  world.add(Valley{});
  CHECK(energy_of(world).stored == 9);  // J
  for (int n = 0; n < 1000; ++n) world.step();
  const WorldEnergy energy = energy_of(world);
  CHECK(energy.motion > 5);
  CHECK(std::abs(energy.motion + energy.stored - 9) < 0.0065);  // half a step of |F v| at most
}
//! [energy.hpp]

TEST_CASE("A step that would not be finite is taken back") {
  //! [failure.hpp]
  World<double> world;
  const BodyHandle ball = world.add("ball", make_particle<double>(1, {0, 0, 5}));
  world.push_at(ball, {0, 0, 1e308}, {0, 0, 5});
  world.push_at(ball, {0, 0, 1e308}, {0, 0, 5});
  try {
    world.step();
  } catch (const SimulationError& error) {
    CHECK(std::string(error.what()).find("'ball'") != std::string::npos);
  }
  CHECK(world.position(ball).z() == 5);  // as before the step
  //! [failure.hpp]
}

TEST_CASE("A world is saved to a file and read back, and a checkpoint goes back a few frames") {
  //! [snapshot_file.hpp snapshot.hpp]
  World<double> world;
  const BodyHandle ball = world.add("ball", make_particle<double>(1, {0, 0, 5}, {1, 0, 0}));
  std::stringstream file;
  write_snapshot(file, world.save());                   // how all bodies move now
  const Checkpoint<double> frame = world.checkpoint();  // the same, for this run of the program
  for (int n = 0; n < 30; ++n) world.step();
  world.restore(frame);
  CHECK(world.ticks() == 0);
  world.step();
  world.restore(read_snapshot<double>(file));
  CHECK(world.position(ball) == Vec3d(0, 0, 5));
  //! [snapshot_file.hpp snapshot.hpp]
}

TEST_CASE("A push that arrives late is played in the frame that it was meant for") {
  //! [checkpoints.hpp]
  World<double> world(steps_per_second(64));
  const BodyHandle ball = world.add("ball", make_particle<double>(1));  // kg
  std::map<std::int64_t, Vec3d> pushes;                                 // N, by the tick
  std::map<std::int64_t, Checkpoint<double>> frames;
  const auto play_to = [&](std::int64_t tick) {
    while (world.ticks() < tick) {
      frames.insert_or_assign(world.ticks(), world.checkpoint());
      if (const auto push = pushes.find(world.ticks()); push != pushes.end())
        world.push(ball, {.force = push->second});
      world.step();
    }
  };
  play_to(60);
  pushes[40] = {0, 0, 32};  // what another player did twenty frames ago
  world.restore(frames.at(40));
  play_to(60);
  CHECK(world.velocity(ball).z() == 0.5);  // m/s
  CHECK(world.position(ball).z() == 0.5 * 20 / 64);
  frames.erase(frames.begin(), frames.find(50));  // older than anything that may still come
  //! [checkpoints.hpp]
}

TEST_CASE("Two bodies hang on springs, one below the other") {
  //! [springs.hpp]
  World<double> world(steps_per_second(240));
  const BodyHandle upper = world.add("upper", make_particle<double>(1, {0, 0, -1}));
  const BodyHandle lower = world.add("lower", make_particle<double>(2, {0, 0, -2}));
  const Spring<double> spring{.stiffness = 400, .damping = 8, .rest_length = 1};  // N/m, N s/m, m
  world.add(Gravity<double>{});
  world.add(SpringToPoint<double>{.spring = spring}, {upper});  // to the origin
  const EffectHandle link = world.add(SpringBetween<double>{.spring = spring}, {upper, lower});
  CHECK(world.step_limit().time_step > 1.0 / 240);  // s; no spring feeds on itself
  for (int n = 0; n < 240 * 20; ++n) world.step();
  CHECK(std::abs(world.position(upper).z() + 1 + 3 * 9.81 / 400) < 1e-3);  // m
  const auto& all = world.bodies();
  const auto state = [&](BodyHandle body) { return state_of(all, world.index_of(body)); };
  SpringBetween<double> spring_between = world.effect<SpringBetween<double>>(link);
  const auto pull = spring_between.push(state(upper), state(lower), world.time());
  CHECK(std::abs(pull.force_on_first.z() + 2 * 9.81) < 1e-3);  // N: it bears the lower body
  spring_between.spring.stiffness = 800;
  world.change(link, spring_between);  // from the next step on
  //! [springs.hpp]
}

TEST_CASE("A spinning ball is slowed by the air and led aside") {
  //! [air_and_water.hpp]
  World<double> world(steps_per_second(120));
  const auto solid = mass_properties(HollowSphere<double>{0.11}, 0.43);  // m; kg
  const auto made = make_rigid_body("ball", solid, {}, Vec3d(30, 0, 0), Vec3d(0, 0, 60));
  const BodyHandle ball = world.add("ball", made.body);
  world.add(QuadraticDrag<double>{.coefficient = drag_coefficient(1.2, 0.3, 0.038)});
  world.add(AngularDamping<double>{.rate = 0.1});  // 1/s
  world.add(Magnus<double>{.strength = 1e-3});     // kg
  for (int n = 0; n < 120; ++n) world.step();
  CHECK(world.position(ball).y() > 1);  // m: to the left, since it turns to the left
  //! [air_and_water.hpp]
}

TEST_CASE("The books of a world close, and its energy is told by kinds") {
  //! [ledger.hpp]
  World<double> world(steps_per_second(64));
  world.add("stone", make_particle<double>(2, {0, 0, 8}, {1, 0, 4}));  // kg, m, m/s
  world.add(Gravity<double>{});
  world.add(LinearDamping<double>{.rate = 0.25});  // 1/s
  Ledger<double> ledger(world);
  for (int n = 0; n < 64; ++n) ledger.step(world);
  CHECK(std::abs(ledger.rest(world).energy) < 1e-10);  // J that no effect explains
  CHECK(energy_of(world).motion < 17 + 2 * 9.81 * 8);
  //! [ledger.hpp]
}

TEST_CASE("A drawing shows the bodies between two steps") {
  //! [drawing.hpp]
  World<double> world(steps_per_second(10));
  // A hammer, modelled from the middle of its handle: its centre of mass lies elsewhere.
  const auto handle = mass_properties(Box<double>{{0.03, 0.03, 0.3}}, 0.2);  // m; kg
  const auto head = mass_properties(Box<double>{{0.12, 0.04, 0.04}}, 0.8);
  const auto moved_head = moved(head, Mat3d::Identity(), {0, 0, 0.17});
  const auto both = combined<double>({handle, moved_head});
  const auto made = make_rigid_body("hammer", both, {}, Vec3d(1, 0, 0));  // m/s
  const BodyHandle hammer = world.add("hammer", made.body);
  Drawing<double> drawing;
  drawing.set_model(hammer, made.model_in_body);
  drawing.note(world);
  world.step();
  drawing.note(world);  // after each step
  // Halfway in time the model's origin is halfway there; the centre of mass lies beside it.
  CHECK((drawing.pose(hammer, 0.5).position - Vec3d(0.05, 0, 0)).norm() < 1e-12);  // m
  //! [drawing.hpp]
}

TEST_CASE("A stone falls, and a planet in its place pulls it to itself") {
  //! [gravity.hpp]
  World<double> world(steps_per_second(100));
  const BodyHandle stone = world.add("stone", make_particle<double>(2, {0, 0, 5}));  // kg; m
  const EffectHandle falling = world.add(Gravity<double>{});  // 9.81 m/s² downwards, for every body
  for (int n = 0; n < 100; ++n) world.step();
  CHECK(std::abs(world.velocity(stone).z() + 9.81) < 1e-9);  // m/s
  world.remove(falling);
  world.add(PointGravity<double>{.strength = 3.986e14}, {stone});  // GM, m³/s²; about the origin
  //! [gravity.hpp]
}

TEST_CASE("A thruster burns between two times, and gravity pulls to a point") {
  //! [thruster.hpp]
  World<double> sky(steps_per_second(50));
  const auto hull = mass_properties(Box<double>{{1, 1, 2}}, 100.0);  // m; kg
  const auto made = make_rigid_body("probe", hull, {.position = {7e6, 0, 0}}, Vec3d(0, 7500, 0));
  const BodyHandle probe = sky.add("probe", made.body);
  sky.add(PointGravity<double>{.strength = 3.986e14});  // GM, m³/s²
  sky.add(Thruster<double>{.force_body = {0, 50, 0}, .from = 1, .until = 3}, {probe});  // N, s
  for (int n = 0; n < 200; ++n) sky.step();
  CHECK(sky.velocity(probe).y() > 7500.9);  // m/s: 50 N for 2 s on 100 kg
  //! [thruster.hpp]
}

TEST_CASE("Ten thousand bodies are stepped in packs, on two threads") {
  //! [in_packs.hpp]
  ManyBodies<float> rain(steps_per_second(60));
  std::vector<BodyHandle> drops;
  for (int n = 0; n < 10'000; ++n)
    drops.push_back(rain.add(make_particle<float>(1e-3f, {float(n), 0, 100})));  // kg; m
  rain.add(Gravity<float>{});
  rain.add(QuadraticDrag<float>{.coefficient = 1e-5f});  // kg/m
  rain.use_threads(2);
  for (int n = 0; n < 60; ++n) rain.step();
  float lowest = 100;  // m
  for (const BodyHandle drop : drops) lowest = std::min(lowest, rain.position(drop).z());
  CHECK(lowest < 96);                       // 4.8 m in a second, and the air holds it back
  const Bodies<float> all = rain.bodies();  // or a copy of everything
  CHECK(all.centres[9'998].position.x() == 9'998);
  //! [in_packs.hpp]
}

TEST_CASE("A world turns by another rule and steps by another scheme") {
  //! [turning_rungs.hpp turning_methods.hpp scheme.hpp]
  World<double> world(steps_per_second(60));
  const auto solid = mass_properties(Box<double>{{0.1, 0.2, 0.3}}, 2.0);
  world.add("box", make_rigid_body("box", solid, {}, Vec3d(0, 0, 0), Vec3d(0.1, 5, 0.1)).body);
  world.turn_by(SplittingSuzuki{});  // order 4
  world.step_by(Scheme::suzuki);
  CHECK(world.plan().accuracy.order == 4);
  //! [turning_rungs.hpp turning_methods.hpp scheme.hpp]
}

TEST_CASE("A planet chooses its own steps, and comes back to where the exact orbit does") {
  //! [embedded_steps.hpp kepler.hpp]
  Particle<double> planet = make_particle(1.0, {1, 0, 0}, {0, 1.2, 0});
  const auto attract = [](Particle<double>& p, double /*time*/) {
    p.force = -p.position / std::pow(p.position.norm(), 3);  // N, for 1 kg and GM = 1 m³/s²
  };
  const exact::KeplerOrbit<double> orbit(planet, 1.0);
  const StepCounts counts = integrate<DormandPrince853>(planet, attract, 0.0, orbit.period(),
                                                        {.position = 1e-10, .velocity = 1e-10});
  CHECK(counts.steps < 100);
  CHECK((planet.position - orbit.at(orbit.period()).position).norm() < 1e-8);  // m
  //! [embedded_steps.hpp kepler.hpp]
}

TEST_CASE("A top under a torque chooses its own steps, to a tolerance in radians") {
  //! [embedded_steps.hpp]
  Top<double> top{.angular_momentum_body = {0.1, 3, 0.1}, .inverse_moments = {1, 0.5, 0.4}};
  const auto brake = [](Top<double>& t, double /*time*/) {
    t.torque = rotate(t.orientation, -0.1 * t.angular_momentum_body);  // N m, world axes
  };
  integrate<DormandPrince54>(top, brake, 0.0, 10.0, 1e-9);  // from 0 s through 10 s
  const double kept = top.angular_momentum_body.norm() / Vec3d(0.1, 3, 0.1).norm();
  CHECK(std::abs(kept - std::exp(-1)) < 1e-7);
  //! [embedded_steps.hpp]
}

TEST_CASE("A free top is taken to where the exact solution has it, by steps of its own choice") {
  //! [reduced_steps.hpp free_top.hpp]
  Top<double> top{.angular_momentum_body = {0.1, 3, 0.1}, .inverse_moments = {1, 0.5, 0.4}};
  const exact::FreeTop<double> solution(top);
  const StepCounts counts = integrate_free_top<DormandPrince853>(top, 10.0, 1e-9);  // s; rad/s
  CHECK(counts.steps < 200);
  const Quaternion<double> apart = conjugate(top.orientation) * solution.at(10.0).orientation;
  CHECK(rotation_vector_of(apart).norm() < 1e-8);  // rad: 10 s of 1e-9 rad in each
  //! [reduced_steps.hpp free_top.hpp]
}

TEST_CASE("A toy gyroscope is set on its tip, sinks and comes up again") {
  //! [gyroscope.hpp]
  const auto disc = mass_properties(Cylinder<double>{0.03, 0.01}, 0.1);  // m; kg
  const Gyroscope<double> toy = on_its_tip(disc, 0.04, 9.81);            // m; m/s²
  const double tilt = std::numbers::pi / 3, spin = 400;                  // rad; rad/s
  Top<double> top = set_spinning(toy, tilt, spin);                       // and let go
  const double lowest = lowest_cosine(toy, std::cos(tilt), spin);
  for (int n = 0; n < 1000; ++n) {
    add_weight(top, toy);
    kick(top, 1e-3);  // s
    drift(top, 1e-3);
    clear_torque(top);
    CHECK(axis_of(top).z() > lowest - 1e-3);
    CHECK(axis_of(top).z() < std::cos(tilt) + 1e-3);
  }
  //! [gyroscope.hpp]
}

TEST_CASE("A handle stays that of its body while others come and go") {
  //! [handles.hpp]
  World<double> world(steps_per_second(60));
  const BodyHandle red = world.add("red", make_particle(1.0));
  const BodyHandle blue = world.add("blue", make_particle(2.0));
  std::map<BodyHandle, int> score{{red, 3}, {blue, 5}};  // what a program remembers of each
  world.remove(red);
  CHECK(!world.contains(red));
  CHECK(score.at(world.find("blue")) == 5);
  CHECK(mass_of(world.body(blue).centre) == 2);  // kg
  //! [handles.hpp]
}

TEST_CASE("A plan says which bodies each part of the step visits, and why") {
  //! [plan.hpp]
  World<double> world(steps_per_second(60));
  world.add("drop", make_particle<double>(0.001, {0, 0, 10}));  // kg; m
  world.add(Gravity<double>{});
  world.add(Magnus<double>{.strength = 1e-3});  // kg
  const Plan plan = world.plan();
  std::string said;
  for (const PlanRow& row : plan.rows)
    if (row.visited == 0) said += row.effect + ": " + row.reason + '\n';
  CHECK(said.find("Magnus") != std::string::npos);  // a point does not spin
  CHECK(plan.passes() == 3);                        // gravity, the kick and the drift
  CHECK(plan.warnings.empty());
  //! [plan.hpp]
}

TEST_CASE("A wheel that is spun up turns its body the other way") {
  //! [reaction_wheel.hpp]
  World<double> sky(steps_per_second(50));
  const auto hull =
      mass_properties(Box<double>{{1, 1, 1}}, 120.0);  // m; kg: 20 kg m² about each axis
  const BodyHandle probe = sky.add("probe", make_rigid_body("probe", hull).body);
  sky.add(ReactionWheel<double>{.axis = {0, 1, 0}, .torque = 0.5, .until = 2}, {probe});  // N m; s
  for (int n = 0; n < 200; ++n) sky.step();
  const Vec3d turning = angular_velocity_body(sky.body(probe).top);
  CHECK(std::abs(turning.y() + 0.5 * 2 / 20) < 1e-12);  // rad/s
  //! [reaction_wheel.hpp]
}
