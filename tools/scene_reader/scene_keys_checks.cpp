// Each key of a scene file against what was built of it. The numbers on the right are worked out
// here, by textbook formulas or by hand, and share nothing with the loader.
#include <random>
#include <support/bad_scenes.hpp>
#include <support/checks.hpp>
#include <support/push_on.hpp>
#include <tumble/scene/read_scene.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

constexpr double pi = std::numbers::pi;

Scene<double> read(const std::string& text) {
  return read_scene<double>(text, "keys.json");
}

RigidBody<double> body_called(const Scene<double>& scene, const std::string& name) {
  return scene.world.body(scene.world.find(name));
}

/// A scene's one effect and whom it is for.
const EffectInstance<double>& only_effect(const Scene<double>& scene) {
  REQUIRE(scene.world.effects().size() == 1);
  return scene.world.effects()[0];
}

/// What the scene's one effect does to its body number `index` at some time.
Push<double> push_of(const Scene<double>& scene, BodyIndex index = 0, double time = 0) {
  return push_on(*only_effect(scene).effect, state_of(scene.world.bodies(), index), time);
}

/// The largest number that is compared times this bounds what a dozen operations round.
constexpr double roundings = 64 * unit_roundoff<double>;

bool close(const Vec3d& value, const Vec3d& expected) {
  return distance(value, expected) <= roundings * (1 + expected.cwiseAbs().maxCoeff());
}
bool close(double value, double expected) {
  return std::abs(value - expected) <= roundings * (1 + std::abs(expected));
}

/// A quarter turn about z: model x is world y, model y is world −x.
const std::string quarter = R"("orientation": {"axis": [0, 0, 2], "angle": 1.5707963267948966})";

/// A body of 2 kg whose centre of mass lies at model (0.5, 0, 0), with 4, 3 and 2 kg m² about the
/// model's axes, its model's origin at world (1, 2, 3), turned by a quarter about z. So the centre
/// of mass is at (1, 2.5, 3).
const std::string odd_body =
    R"({"name": "odd", "mass": 2, "inertia": [4, 3, 2], "centre_of_mass": [0.5, 0, 0],
        "position": [1, 2, 3], "velocity": [3, 4, 0], "angular_velocity": [0, 0, 5], )" +
    quarter + "}";

Scene<double> odd_with(const std::string& kind, const std::string& more) {
  return read(scene_of(odd_body, effect(kind, more)));
}

}  // namespace

TEST_CASE("The step of a scene is so many in a second, or so many nanoseconds, or a 60th second") {
  const auto step_of = [](const std::string& step) {
    const Scene<double> scene = read(scene_of(ball, "", step));
    return time_step_of<double>(scene.world.step_length());
  };
  CHECK(step_of(R"("step": {"per_second": 250},)") == 1.0 / 250);
  CHECK(step_of(R"("step": {"nanoseconds": 2000000},)") == 0.002);
  CHECK(step_of("") == 1.0 / 60);
}

TEST_CASE(
    "Title, description, duration, turning method and scheme are the file's, or the default") {
  const Scene<double> said = read(R"({"title": "T", "description": "D", "duration": 3.5,
    "turning_method": "axis_by_axis", "scheme": "verlet", "bodies": [{"name": "a", "mass": 1}]})");
  CHECK(said.title == "T");
  CHECK(said.description == "D");
  CHECK(said.duration == 3.5);
  CHECK(said.world.turning_method() == "axis by axis");
  CHECK(said.world.scheme() == Scheme::verlet);
  const Scene<double> bare = read(R"({"duration": 1, "bodies": [{"name": "a", "mass": 1}]})");
  CHECK(bare.title == "keys.json");
  CHECK(bare.description.empty());
  CHECK(bare.world.turning_method() == "splitting");
  CHECK(bare.world.scheme() == Scheme::semi_implicit_euler);
  CHECK(bare.world.effects().empty());
}

TEST_CASE("Whoever reads a scene may want another step, method or scheme than the file says") {
  const auto& methods = turning_method_words<FirstTurningRules>();
  const auto steady = std::find(methods.begin(), methods.end(), "steady") - methods.begin();
  const Scene<double> scene = read_scene<double>(R"({"duration": 1, "step": {"per_second": 250},
      "turning_method": "axis_by_axis", "scheme": "verlet", "bodies": [{"name": "a", "mass": 1}]})",
                                                 "keys.json",
                                                 {.step = steps_per_second(100),
                                                  .turning_method = std::size_t(steady),
                                                  .scheme = Scheme::semi_implicit_euler});
  CHECK(time_step_of<double>(scene.world.step_length()) == 1.0 / 100);
  CHECK(scene.world.turning_method() == "steady");
  CHECK(scene.world.scheme() == Scheme::semi_implicit_euler);
}

TEST_CASE("A point has the mass, the position and the velocity of the file, or zero") {
  const Scene<double> scene = read(scene_of(
      R"({"name": "p", "mass": 4, "position": [1, 2, 3], "velocity": [-4, 5, 6]}, )" + drop));
  const RigidBody<double> point = body_called(scene, "p");
  CHECK(point.centre.inverse_mass == 0.25);
  CHECK(same_bits(point.centre.position, Vec3d(1, 2, 3)));
  CHECK(same_bits(point.centre.velocity, Vec3d(-4, 5, 6)));
  CHECK(same_bits(body_called(scene, "drop").centre.position, Vec3d(0, 0, 0)));
  CHECK(same_bits(body_called(scene, "drop").centre.velocity, Vec3d(0, 0, 0)));
  CHECK(scene.world.top_count() == 0);
}

TEST_CASE("A static body lies where the file says, turned as it says, and nothing can move it") {
  const Scene<double> scene = read(scene_of(
      R"({"name": "nail", "static": true, "position": [1, 2, 3], "orientation": [0, 0.6, 0.8, 0]})"));
  const RigidBody<double> nail = body_called(scene, "nail");
  CHECK(nail.centre.inverse_mass == 0);
  CHECK(same_bits(nail.top.inverse_moments, Vec3d(0, 0, 0)));
  CHECK(same_bits(nail.centre.position, Vec3d(1, 2, 3)));
  CHECK(close(rotate(nail.top.orientation, Vec3d(1, 0, 0)), Vec3d(-0.28, 0.96, 0)));
}

TEST_CASE("Mass, inertia, centre of mass, pose, velocity and angular velocity are the file's") {
  const Scene<double> scene = read(scene_of(odd_body));
  const RigidBody<double> odd = body_called(scene, "odd");
  CHECK(odd.centre.inverse_mass == 0.5);
  CHECK(close(odd.centre.position, {1, 2.5, 3}));
  CHECK(same_bits(odd.centre.velocity, Vec3d(3, 4, 0)));
  CHECK(close(angular_velocity_world(odd.top), {0, 0, 5}));
  const Mat3d world = world_inertia(odd.top);  // model x lies along y
  CHECK((world - Mat3d(Vec3d(3, 4, 2).asDiagonal())).cwiseAbs().maxCoeff() <= 4 * roundings);
  const Posed& model = scene.models[0].model_in_body;
  CHECK(close(inverse(model).position, {0.5, 0, 0}));
  CHECK(close(rotate(odd.top.orientation * model.orientation, Vec3d(1, 0, 0)), {0, 1, 0}));
}

TEST_CASE("An angular velocity is given in world axes, also of a body that lies turned") {
  const Scene<double> scene = read(scene_of(
      R"({"name": "b", "mass": 1, "inertia": [1, 2, 2.5], "angular_velocity": [1, 2, 3], )" +
      quarter + "}"));
  const Top<double> top = body_called(scene, "b").top;
  CHECK(close(angular_velocity_world(top), {1, 2, 3}));
  CHECK(close(angular_momentum_world(top), {2, 2, 7.5}));  // 2 kg m² along world x, 1 along y
}

TEST_CASE("Nine numbers of a tensor stand in its rows and columns") {
  const Scene<double> scene = read(scene_of(
      R"({"name": "b", "mass": 2, "inertia": [[3, 0.1, 0.2], [0.1, 4, 0.3], [0.2, 0.3, 5]]})"));
  Mat3d expected;
  expected << 3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5;
  const Mat3d built = world_inertia(body_called(scene, "b").top);
  CHECK((built - expected).cwiseAbs().maxCoeff() <= 5 * roundings);
}

TEST_CASE("Turning is free, locked where the body is thin, or locked") {
  const auto inverse_moments = [](const std::string& turning) {
    const Scene<double> scene = read(scene_of(
        R"({"name": "rod", "mass": 3, "solid": {"shape": "thin_rod", "length": 2}, "turning": ")" +
        turning + "\"}"));
    return body_called(scene, "rod").top.inverse_moments;
  };
  CHECK(same_bits(inverse_moments("locked"), Vec3d(0, 0, 0)));
  const Vec3d thin = inverse_moments("locked_where_thin");  // 3 kg · 4 m²/12 = 1 kg m²
  CHECK(close(thin.sum(), 2));
  CHECK((thin.array() == 0).count() == 1);
  const Scene<double> free = read(scene_of(odd_body));
  CHECK((body_called(free, "odd").top.inverse_moments.array() > 0).all());
  CHECK_THROWS_AS(inverse_moments("free"), SceneError);
}

TEST_CASE("Every shape weighs what textbooks say, along its own axes") {
  struct Case {
    std::string shape;     // its keys
    double volume;         // 0: it has none
    Vec3d centre_of_mass;  // m, model axes
    Vec3d moments;         // of 1 kg about the centre of mass, along the model's axes
    std::array<double, 3> products = {};  // I_xy, I_xz and I_yz of 1 kg
  };
  const double third = 4 * pi / 3;
  const double shell = 2.0 / 5 * (32 - 1) / (8 - 1);  // from 1 m to 2 m: (b⁵ − a⁵)/(b³ − a³)
  // A capsule of radius 1 and length 3: both its half balls make a ball, shifted by 3/2 and 3/8 r.
  const double part = 3 * pi / (3 * pi + third), ends = 1 - part;
  const double across = part * (3 + 9) / 12 + ends * (2.0 / 5 + 9.0 / 4 + 3.0 / 8 * 3);
  for (const Case& solid : {
           Case{R"("sphere", "radius": 2)", third * 8, {0, 0, 0}, Vec3d::Constant(8.0 / 5)},
           Case{R"("hollow_sphere", "radius": 2)", 0, {0, 0, 0}, Vec3d::Constant(8.0 / 3)},
           Case{R"("spherical_shell", "inner_radius": 1, "outer_radius": 2)",
                third * 7,
                {0, 0, 0},
                Vec3d::Constant(shell)},
           Case{R"("box", "size": [1, 2, 3])", 6, {0, 0, 0}, Vec3d(13, 10, 5) / 12},
           Case{R"("ellipsoid", "semi_axes": [1, 2, 3])",
                third * 6,
                {0, 0, 0},
                Vec3d(13, 10, 5) / 5},
           Case{R"("cylinder", "radius": 2, "height": 6)", 24 * pi, {0, 0, 0}, {4, 4, 2}},
           Case{R"("cone", "radius": 2, "height": 4)", 16 * pi / 3, {0, 0, 1}, {1.2, 1.2, 1.2}},
           Case{R"("cone", "radius": 1, "height": 8)", 8 * pi / 3, {0, 0, 2}, {2.55, 2.55, 0.3}},
           Case{R"("capsule", "radius": 1, "length": 3)",
                3 * pi + third,
                {0, 0, 0},
                {across, across, part / 2 + ends * 2 / 5}},
           Case{R"("thin_plate", "width": 1, "height": 2)", 0, {0, 0, 0}, Vec3d(4, 1, 5) / 12},
           Case{R"("mesh", "corners": [[0, 0, 0], [4, 0, 0], [0, 8, 0], [0, 0, 12]],
                   "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])",
                64,
                {1, 2, 3},
                Vec3d(208, 160, 80) * 3 / 80,
                {32 / 80.0, 48 / 80.0, 96 / 80.0}},
           Case{R"("compound", "parts": [
                  {"mass": 0.25, "solid": {"shape": "sphere", "radius": 1}, "position": [4, 0, 0]},
                  {"mass": 0.75, "solid": {"shape": "box", "size": [1, 2, 3]},
                   "position": [0, 0, 0]}])",
                0,
                {1, 0, 0},
                {0.1 + 13.0 / 16, 0.1 + 10.0 / 16 + 3, 0.1 + 5.0 / 16 + 3}},  // 3 = ¼·9 + ¾·1
       }) {
    CAPTURE(solid.shape);
    const auto body = [&](const std::string& amount) {
      const std::string with = amount.empty() ? "" : amount + ", ";
      const Scene<double> scene =
          read(scene_of(R"({"name": "b", )" + with + R"("position": [10, 20, 30], "solid":)" +
                        R"({"shape": )" + solid.shape + "}}"));
      return body_called(scene, "b");
    };
    const bool is_compound = solid.shape.starts_with("\"compound");
    const RigidBody<double> made = body(is_compound ? "" : R"("mass": 2)");
    const double mass = is_compound ? 1 : 2;
    CHECK(close(1 / made.centre.inverse_mass, mass));
    CHECK(close(made.centre.position, Vec3d(10, 20, 30) + solid.centre_of_mass));
    Mat3d inertia = solid.moments.asDiagonal();
    inertia(0, 1) = inertia(1, 0) = solid.products[0];
    inertia(0, 2) = inertia(2, 0) = solid.products[1];
    inertia(1, 2) = inertia(2, 1) = solid.products[2];
    CHECK((world_inertia(made.top) - mass * inertia).cwiseAbs().maxCoeff() <= 100 * roundings);
    if (solid.volume > 0)
      CHECK(close(1 / body(R"("density": 0.5)").centre.inverse_mass / solid.volume, 0.5));
  }
}

TEST_CASE("What is drawn of a solid has the lengths of the file, and a part stands in its place") {
  const auto part = [](const std::string& shape) {
    const Scene<double> scene =
        read(scene_of(R"({"name": "b", "static": true, "solid": {"shape": )" + shape + "}}"));
    REQUIRE(scene.models[0].parts.size() == 1);
    return scene.models[0].parts[0].solid;
  };
  CHECK(std::get<Sphere<double>>(part(R"("sphere", "radius": 2)")).radius == 2);
  CHECK(std::get<HollowSphere<double>>(part(R"("hollow_sphere", "radius": 2)")).radius == 2);
  const auto shell = std::get<SphericalShell<double>>(
      part(R"("spherical_shell", "inner_radius": 1, "outer_radius": 2)"));
  CHECK(shell.inner_radius == 1);
  CHECK(shell.outer_radius == 2);
  const Solid box = part(R"("box", "size": [1, 2, 3])");
  CHECK(same_bits(std::get<Box<double>>(box).size, Vec3d(1, 2, 3)));
  const Solid egg = part(R"("ellipsoid", "semi_axes": [1, 2, 3])");
  CHECK(same_bits(std::get<Ellipsoid<double>>(egg).semi_axes, Vec3d(1, 2, 3)));
  const auto log = std::get<Cylinder<double>>(part(R"("cylinder", "radius": 2, "height": 6)"));
  CHECK(log.radius == 2);
  CHECK(log.height == 6);
  const auto cone = std::get<Cone<double>>(part(R"("cone", "radius": 2, "height": 4)"));
  CHECK(cone.radius == 2);
  CHECK(cone.height == 4);
  const auto pill = std::get<Capsule<double>>(part(R"("capsule", "radius": 1, "length": 3)"));
  CHECK(pill.radius == 1);
  CHECK(pill.length == 3);
  CHECK(std::get<ThinRod<double>>(part(R"("thin_rod", "length": 3)")).length == 3);
  const auto sheet = std::get<ThinPlate<double>>(part(R"("thin_plate", "width": 1, "height": 2)"));
  CHECK(sheet.width == 1);
  CHECK(sheet.height == 2);
  const Scene<double> scene = read(scene_of(R"({"name": "b", "solid": {"shape": "compound",
    "parts": [{"mass": 1, "solid": {"shape": "sphere", "radius": 1}, "position": [4, 5, 6], )" +
                                            quarter + "}]}}"));
  const ModelPart& moved = scene.models[0].parts[0];
  CHECK(same_bits(moved.in_model.position, Vec3d(4, 5, 6)));
  CHECK(close(rotate(moved.in_model.orientation, Vec3d(1, 0, 0)), {0, 1, 0}));
}

TEST_CASE("Gravity pulls as the file says, as a force or as an acceleration") {
  const std::string g = R"("acceleration": [0.5, 1, -9])";
  const Scene<double> force = odd_with("gravity", g);
  CHECK(same_bits(push_of(force).force, Vec3d(1, 2, -18)));
  CHECK(only_effect(force).effect->phase() == Phase::force);
  CHECK(only_effect(force).effect->name() == "gravity");
  const Scene<double> acceleration = odd_with("gravity_as_acceleration", g);
  CHECK(same_bits(push_of(acceleration).force, Vec3d(1, 2, -18)));
  CHECK(only_effect(acceleration).effect->phase() == Phase::kick);
  CHECK(only_effect(acceleration).effect->name() == "gravity as acceleration");
}

TEST_CASE("Point gravity pulls towards its centre, the world's origin if there is none") {
  // From (1, −1.5, 3) to the body at (1, 2.5, 3) it is 4 m along y: 2 kg · 8/16 m/s².
  const Scene<double> centred =
      odd_with("point_gravity", R"("strength": 8, "centre": [1, -1.5, 3])");
  CHECK(close(push_of(centred).force, {0, -1, 0}));
  const double square = 1 + 6.25 + 9;
  CHECK(close(push_of(odd_with("point_gravity", R"("strength": 8)")).force,
              -2 * 8 / square / std::sqrt(square) * Vec3d(1, 2.5, 3)));
}

TEST_CASE("Damping of the velocity and of the spin have the rate of the file") {
  const double kept = std::exp(-0.5 / 60);
  Scene<double> linear = odd_with("linear_damping", R"("rate": 0.5)");
  linear.world.step();
  CHECK(close(body_called(linear, "odd").centre.velocity, kept * Vec3d(3, 4, 0)));
  CHECK(close(angular_velocity_world(body_called(linear, "odd").top), {0, 0, 5}));
  Scene<double> angular = odd_with("angular_damping", R"("rate": 0.5)");
  angular.world.step();
  CHECK(close(body_called(angular, "odd").centre.velocity, {3, 4, 0}));
  CHECK(close(angular_velocity_world(body_called(angular, "odd").top), {0, 0, 5 * kept}));
}

TEST_CASE("Drag and the Magnus force have the coefficient, the sign and the wind of the file") {
  // Through the wind of (0, 4, 0) the body flies with (3, 0, 0); its spin of 5 rad/s about z makes
  // 5 z × 3 x = 15 y of it. In still air 5 z × (3, 4, 0) = (−20, 15, 0).
  CHECK(close(push_of(odd_with("quadratic_drag", R"("coefficient": 2, "wind": [0, 4, 0])")).force,
              {-18, 0, 0}));
  CHECK(close(push_of(odd_with("quadratic_drag", R"("coefficient": 2)")).force, {-30, -40, 0}));
  CHECK(
      close(push_of(odd_with("magnus", R"("strength": 2, "wind": [0, 4, 0])")).force, {0, 30, 0}));
  CHECK(close(push_of(odd_with("magnus", R"("strength": -2)")).force, {40, -30, 0}));
}

TEST_CASE("Buoyancy has the density, the radius, the surface and the gravity of the file") {
  // The centre lies at z = 3. A ball of radius 2 under a surface at z = 3 is half below, at z = 9
  // wholly; without the key the surface is at z = 0, and a ball of radius 4 has a cap of 1 m in.
  const auto lift = [](const std::string& more) {
    return push_of(odd_with("buoyancy", R"("density": 10, )" + more)).force;
  };
  const double half = 2 * pi / 3 * 8, whole = 2 * half, cap = pi * (4 - 1.0 / 3);
  CHECK(close(lift(R"("radius": 2, "surface": 3, "gravity": 3)"), {0, 0, 10 * half * 3}));
  CHECK(close(lift(R"("radius": 2, "surface": 9, "gravity": 3)"), {0, 0, 10 * whole * 3}));
  CHECK(close(lift(R"("radius": 2, "surface": 3)"), {0, 0, 10 * half * 9.81}));
  CHECK(close(lift(R"("radius": 4, "gravity": 3)"), {0, 0, 10 * cap * 3}));
}

TEST_CASE("A spring has the stiffness, damper, rest length, anchor and attachment of the file") {
  // It holds the model's point (0.5, 1, 0), which lies 1 m along model y from the centre of mass:
  // at world (0, 2.5, 3). There the spin of 5 rad/s adds 5 z × (−x) = −5 y to the velocity: (3, −1,
  // 0). The anchor (−2, 2.5, 3) is 2 m away along −x.
  const std::string place =
      R"("bodies": ["odd"], "attachment": [0.5, 1, 0], "anchor": [-2, 2.5, 3])";
  const auto push = [&](const std::string& more) {
    return push_of(odd_with("spring", place + more));
  };
  const auto pulls = [&](const std::string& more, double tension) {
    const Push<double> given = push(more);
    CHECK(close(given.force, {-tension, 0, 0}));
    CHECK(close(given.torque, {0, 0, 0}));  // the arm lies along the force
  };
  pulls(R"(, "stiffness": 10)", 20);
  pulls(R"(, "stiffness": 10, "rest_length": 0.5)", 15);
  pulls(R"(, "stiffness": 10, "damping": 4)", 20 + 4 * 3);
  pulls(R"(, "stiffness": 10, "damping": 4, "rest_length": 3)", -10 + 4 * 3);
  pulls(R"(, "stiffness": 10, "rest_length": 3, "only_pulls": true)", 0);
  pulls(R"(, "stiffness": 10, "rest_length": 3, "only_pulls": false)", -10);
  // Without an attachment it holds the centre of mass, and has no arm.
  const Scene<double> central = odd_with(
      "spring", R"("bodies": ["odd"], "stiffness": 10, "anchor": [1, 2.5, 5], "name": "rope")");
  CHECK(close(push_of(central).force, {0, 0, 20}));
  CHECK(same_bits(push_of(central).torque, Vec3d(0, 0, 0)));
  CHECK(only_effect(central).effect->name() == "rope");
  // An anchor across the arm: (0, 2.5, 5) is 2 m above; the torque is −x × 20 z = 20 y.
  const Push<double> turned =
      push_of(odd_with("spring", R"("bodies": ["odd"], "stiffness": 10, "attachment": [0.5, 1, 0],
                                    "anchor": [0, 2.5, 5])"));
  CHECK(close(turned.force, {0, 0, 20}));
  CHECK(close(turned.torque, {0, 20, 0}));
}

TEST_CASE("A spring between bodies holds each where the file says, in that body's own axes") {
  // The first is the odd body, held at (0, 2.5, 3) as above. Of the second, not turned, the model's
  // origin is its centre of mass at (0, 2, 5); the point (0, 0.5, 1) of its model is at (0, 2.5,
  // 6).
  const std::string bodies =
      odd_body + R"(, {"name": "box", "mass": 3, "inertia": [1, 2, 2.5], "position": [0, 2, 5]})";
  const std::string text =
      scene_of(bodies, effect("spring_between", R"("first": "odd", "second": "box",
        "stiffness": 10, "damping": 7, "rest_length": 1, "only_pulls": true, "name": "chain",
        "attachment_first": [0.5, 1, 0], "attachment_second": [0, 0.5, 1])"));
  const Scene<double> scene = read(text);
  const EffectInstance<double>& entry = only_effect(scene);
  CHECK(entry.effect->name() == "chain");
  const Bodies<double>& all = scene.world.bodies();
  const PairPush<double> push = push_on(*entry.effect, state_of(all, 0), state_of(all, 1), 0.0);
  // 3 m apart along z, and neither end moves along it: 10 N/m · 2 m.
  CHECK(close(push.force_on_first, {0, 0, 20}));
  CHECK(close(push.torque_on_first, {0, 20, 0}));    // −x × 20 z
  CHECK(close(push.torque_on_second, {-10, 0, 0}));  // (0, 0.5, 1) × −20 z
  CHECK(scene.world.index_of(entry.targets[0]) == 0);
  CHECK(scene.world.index_of(entry.targets[1]) == 1);
}

TEST_CASE("A spring to a point is drawn from where it holds the body to where it hangs") {
  const Scene<double> held = odd_with(
      "spring",
      R"("bodies": ["odd"], "stiffness": 1, "attachment": [0.5, 1, 0], "anchor": [7, 8, 9])");
  REQUIRE(held.springs.size() == 1);
  CHECK(same_bits(held.springs[0][0].point, Vec3d(0.5, 1, 0)));
  CHECK(held.springs[0][0].body == std::optional<std::size_t>(0));
  CHECK(same_bits(held.springs[0][1].point, Vec3d(7, 8, 9)));
  CHECK(!held.springs[0][1].body);
  const Scene<double> central =  // its centre of mass, in model axes
      odd_with("spring", R"("bodies": ["odd"], "stiffness": 1, "anchor": [7, 8, 9])");
  CHECK(close(central.springs[0][0].point, {0.5, 0, 0}));
}

TEST_CASE("A thruster burns from its start until its end, for ever if there is none") {
  // 6 N along model x are 6 N along world y, at model (0.5, 1, 0): from the centre of mass −x.
  const std::string more = R"("bodies": ["odd"], "force": [6, 0, 0], "point": [0.5, 1, 0])";
  const Scene<double> scene = odd_with("thruster", more + R"(, "from": 2, "until": 5)");
  for (const double time : {2.0, 4.9}) {
    CHECK(close(push_of(scene, 0, time).force, {0, 6, 0}));
    CHECK(close(push_of(scene, 0, time).torque, {0, 0, -6}));
  }
  for (const double time : {0.0, 1.9, 5.0, 9.0}) {
    CHECK(same_bits(push_of(scene, 0, time).force, Vec3d(0, 0, 0)));
    CHECK(same_bits(push_of(scene, 0, time).torque, Vec3d(0, 0, 0)));
  }
  const Scene<double> always = odd_with("thruster", more);
  for (const double time : {0.0, 1e9}) CHECK(close(push_of(always, 0, time).force, {0, 6, 0}));
  const Scene<double> never = odd_with("thruster", more + R"(, "from": 2, "until": 2)");
  CHECK(same_bits(push_of(never, 0, 2).force, Vec3d(0, 0, 0)));
  CHECK(scene.switches == std::vector<double>{2, 5});
}

TEST_CASE("A wheel has the axis of the file in body axes, and the momentum of its motor's time") {
  // The model's x is the world's y, wherever the principal axes lie.
  const std::string more = R"("bodies": ["odd"], "axis": [8, 0, 0], "momentum": 2, "torque": 3)";
  const auto momentum_at = [](const Scene<double>& scene, double time) -> Vec3d {
    return rotate<double>(scene.world.body(scene.world.handle_at(0)).top.orientation,
                          only_effect(scene).effect->rotor_angular_momentum_body(time));
  };
  const Scene<double> scene = odd_with("reaction_wheel", more + R"(, "from": 1, "until": 5)");
  for (const auto& [time, momentum] :
       {std::pair(0.0, 2.0), {1.0, 2.0}, {2.0, 5.0}, {5.0, 14.0}, {9.0, 14.0}})
    CHECK(close(momentum_at(scene, time), {0, momentum, 0}));
  CHECK(scene.switches == std::vector<double>{1, 5});
  const Scene<double> still = odd_with("reaction_wheel", R"("bodies": ["odd"], "axis": [1, 0, 0])");
  CHECK(same_bits(momentum_at(still, 100), Vec3d(0, 0, 0)));
  CHECK(still.switches.empty());
}

TEST_CASE("An effect is for the bodies that it names, one copy among them, or for all") {
  const std::string bodies =
      drop + R"(, {"name": "dust", "mass": 1, "many": {"count": 3, "seed": 1}})";
  const auto indices = [&](const std::string& more) {
    const Scene<double> scene =
        read(scene_of(bodies, effect("gravity", R"("acceleration": [0, 0, -1])" + more)));
    const EffectInstance<double>& entry = only_effect(scene);
    CHECK(entry.everyone == entry.targets.empty());
    std::vector<BodyIndex> list;
    for (const BodyHandle& handle : entry.targets) list.push_back(scene.world.index_of(handle));
    return list;
  };
  using List = std::vector<BodyIndex>;
  CHECK(indices("") == List{});
  CHECK(indices(R"(, "bodies": ["drop"])") == List{0});
  CHECK(indices(R"(, "bodies": ["dust"])") == List{1, 2, 3});
  CHECK(indices(R"(, "bodies": ["dust 2", "drop"])") == List{2, 0});
}

TEST_CASE("An effect has the name that the file gives it, whatever its kind") {
  for (const auto& [kind_of_it, more] : std::vector<std::pair<std::string, std::string>>{
           {"gravity", R"("acceleration": [0, 0, 1])"},
           {"gravity_as_acceleration", R"("acceleration": [0, 0, 1])"},
           {"point_gravity", R"("strength": 1)"},
           {"linear_damping", R"("rate": 1)"},
           {"angular_damping", R"("rate": 1)"},
           {"quadratic_drag", R"("coefficient": 1)"},
           {"magnus", R"("strength": 1)"},
           {"buoyancy", R"("density": 1, "radius": 1)"},
           {"spring", R"("stiffness": 1, "anchor": [0, 0, 0], "bodies": ["odd"])"},
           {"thruster", R"("force": [1, 0, 0], "bodies": ["odd"])"},
           {"reaction_wheel", R"("axis": [1, 0, 0], "bodies": ["odd"])"}}) {
    const std::string kind = kind_of_it;  // clang 14 captures no structured binding
    CAPTURE(kind);
    const Scene<double> scene = odd_with(kind, more + R"(, "name": "mine")");
    CHECK(only_effect(scene).effect->name() == "mine");
  }
}

TEST_CASE("Copies are numbered from 1, and so is a single one") {
  for (const int count : {1, 3}) {
    const Scene<double> scene = read(scene_of(R"({"name": "a", "mass": 1, "many": {"seed": 1,
      "count": )" + std::to_string(count) + "}}"));
    REQUIRE(scene.world.body_count() == std::size_t(count));
    for (int n = 1; n <= count; ++n)
      CHECK(scene.world.name_of(scene.world.handle_at(static_cast<BodyIndex>(n - 1))) ==
            "a " + std::to_string(n));
  }
}

TEST_CASE("Copies get place, velocity, spin and orientation from the numbers of the seed") {
  const std::string text =
      scene_of(R"({"name": "b", "mass": 1, "inertia": [1, 2, 2.5], "many": {"count": 2, "seed": 5,
        "position_between": [[0, 1, 2], [3, 5, 9]], "velocity_between": [[-1, -2, -3], [1, 2, 4]],
        "angular_velocity_between": [[1, 2, 3], [2, 4, 8]], "orientation_random": true}})");
  for (const std::uint64_t added : {std::uint64_t(0), std::uint64_t(3)}) {
    const Scene<double> scene = read_scene<double>(text, "many.json", {.seed = added});
    std::mt19937_64 numbers(5 + added);
    const auto fraction = [&] { return std::ldexp(static_cast<double>(numbers() >> 11), -53); };
    const auto between = [&](const Vec3d& low, const Vec3d& high) {
      Vec3d vector;
      for (double& component : vector) component = fraction();
      return Vec3d(low + vector.cwiseProduct(high - low));
    };
    for (const std::string name : {"b 1", "b 2"}) {
      const RigidBody<double> copy = body_called(scene, name);
      CHECK(close(copy.centre.position, between({0, 1, 2}, {3, 5, 9})));
      CHECK(close(copy.centre.velocity, between({-1, -2, -3}, {1, 2, 4})));
      CHECK(close(angular_velocity_world(copy.top), between({1, 2, 3}, {2, 4, 8})));
      const double u = fraction(), a = 2 * pi * fraction(), b = 2 * pi * fraction();
      const Quaternion<double> q{std::sqrt(u) * std::cos(b),
                                 {std::sqrt(1 - u) * std::sin(a), std::sqrt(1 - u) * std::cos(a),
                                  std::sqrt(u) * std::sin(b)}};  // Shoemake 1992
      const Quaternion<double> built =
          copy.top.orientation * scene.models[0].model_in_body.orientation;
      CHECK(angle_between(built, q) <= roundings);
    }
  }
  CHECK_THROWS_AS(read_scene<double>(scene_of(drop), "none.json", {.seed = 1}), SceneError);
}
