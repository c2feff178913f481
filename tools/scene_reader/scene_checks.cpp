#include <fstream>
#include <numbers>
#include <support/bad_scenes.hpp>
#include <support/checks.hpp>
#include <support/exhaustive.hpp>
#include <support/random_world.hpp>
#include <support/shipped_scenes.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/energy.hpp>
#include <tumble/scene/portable_random.hpp>
#include <tumble/scene/read_scene_file.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

std::filesystem::path shipped(const std::string& name) {
  return scenes_folder() / (name + ".json");
}

/// A letter of fewer than 17 bits.
std::string utf8(char32_t letter) {
  const auto byte = [](char32_t bits) {
    return static_cast<char>(static_cast<unsigned char>(bits));
  };
  if (letter < 0x80) return {byte(letter)};
  if (letter < 0x800) return {byte(0xc0 | letter >> 6), byte(0x80 | (letter & 0x3f))};
  return {byte(0xe0 | letter >> 12), byte(0x80 | (letter >> 6 & 0x3f)),
          byte(0x80 | (letter & 0x3f))};
}

/// What is wrong with a scene, after the name of its file. What the parser of JSON adds in brackets
/// is not ours to check: it differs from version to version.
template <class Real>
std::string complaint_of_scene(const std::string& text) {
  try {
    read_scene<Real>(text, "bad.json");
  } catch (const SceneError& error) {
    const std::string what = error.what(), file = "bad.json: ";
    CHECK(what.substr(0, file.size()) == file);
    CHECK(what.substr(file.size()) ==
          plain(error.pointer + (error.pointer.empty() ? "" : " ") + error.sentence));
    const std::string ours = "not valid JSON";
    const std::size_t theirs = what.find(ours);
    if (theirs == std::string::npos) return what.substr(file.size());
    CHECK(what.substr(theirs + ours.size(), 2) == " (");
    return what.substr(file.size(), theirs + ours.size() - file.size());
  }
  return "nothing thrown";
}

/// Steps both ways, and says whether every bit agrees.
template <class Real>
bool planned_equals_reference(World<Real> planned, int steps) {
  World<Real> reference = planned;
  for (int n = 0; n < steps; ++n) {
    planned.step();
    reference.step_by_reference();
  }
  return same_motion(planned.bodies(), reference.bodies());
}

}  // namespace

// The reference run asks what is known of all bodies once for each effect. So it gets a thousand
// drops of the rain and a quarter of the steps where there are many bodies; all drops come below.
TEST_CASE_TEMPLATE(
    "Every shipped scene moves by plan as by the reference run, to the bit: 240 steps, or 60 "
    "where there are over a hundred bodies",
    Real, EVERY_PRECISION) {
  CHECK(shipped_scenes().size() >= 12);
  for (const std::filesystem::path& path : shipped_scenes()) {
    CAPTURE(path.stem().string());
    Scene<Real> scene = read_scene_file<Real>(path, {.most_copies = 1000});
    CHECK(scene.world.plan().warnings.empty());
    const int steps = scene.world.body_count() > 100 ? 60 : 240;
    CHECK(planned_equals_reference(std::move(scene.world), steps));
  }
}

TEST_CASE_TEMPLATE("Every shipped scene moves by plan as when nothing is known of any body", Real,
                   EVERY_PRECISION) {
  for (const std::filesystem::path& path : shipped_scenes()) {
    CAPTURE(path.stem().string());
    Scene<Real> scene = read_scene_file<Real>(path, {.most_copies = 1000});
    settle(scene.world);
    World<Real> exhaustive = scene.world;
    for (int n = 0; n < (scene.world.body_count() > 100 ? 60 : 240); ++n) {
      scene.world.step();
      exhaustive.step_exhaustively();
    }
    CHECK(difference_in_value(scene.world.bodies(), exhaustive.bodies()) == "");
  }
}

TEST_CASE_TEMPLATE("All 100,000 drops of the rain move by plan as by the reference run, to the bit",
                   Real, EVERY_PRECISION) {
  Scene<Real> rain = read_scene_file<Real>(shipped("rain"));
  CHECK(rain.world.body_count() == 100'000);
  CHECK(rain.world.top_count() == 0);
  CHECK(planned_equals_reference(std::move(rain.world), 1));
}

TEST_CASE("The shipped scenes do what their descriptions say") {
  const auto after = [](Scene<double> scene, double seconds) {
    for (int n = 0; n * scene.world.time_step() < seconds; ++n) scene.world.step();
    return scene;
  };
  const auto body_of = [](const Scene<double>& scene, const std::string& name) {
    return scene.world.body(scene.world.find(name));
  };
  /// The axes of the first model in the world.
  const auto axes_of = [&](const Scene<double>& scene) {
    return matrix_of(drawn_pose(body_of(scene, scene.models[0].name), scene.models[0].model_in_body)
                         .orientation);
  };

  // Balls afloat: what is above the water is lighter by as much. The last one hangs on its chain.
  const Scene<double> buoys = after(read_scene_file<double>(shipped("buoys")), 60);
  const auto height = [&](const std::string& name) {
    return body_of(buoys, name).centre.position.z();
  };
  const double cap = height("ice") + 0.1;
  const double above = cap * cap * (0.3 - cap) / (4 * 0.001);
  CHECK(std::round(1 / above) == 12);
  CHECK(height("cork") > height("ice"));
  CHECK(height("oak") < -0.1);

  Scene<double> orbit = read_scene_file<double>(shipped("orbit"));
  double time = 0;
  for (double before = 0, y = 0; !(before < 0 && y >= 0); time += orbit.world.time_step()) {
    before = y;
    orbit.world.step();
    y = body_of(orbit, "station").centre.position.y();
  }
  CHECK(std::round(time / 60) == 92);

  const Scene<double> satellite = read_scene_file<double>(shipped("satellite"));
  const Mat3d turned = axes_of(after(satellite, satellite.duration));
  const double turns = std::acos((turned.trace() - 1) / 2) / (2 * std::numbers::pi);
  CHECK(std::abs(turns - 1 / 3.) < 0.02);

  const Scene<double> wheels = after(read_scene_file<double>(shipped("reaction_wheels")), 60);
  CHECK(std::abs(axes_of(wheels).trace() - 1) < 1e-5);  // 1 + 2 cos of a right angle
  CHECK(angular_velocity_body(body_of(wheels, "telescope").top).norm() < 1e-12);
  const auto steadiness = [&](const std::string& name) {  // of a spin that began along y
    const BodyModel& model = *std::find_if(wheels.models.begin(), wheels.models.end(),
                                           [&](const auto& one) { return one.name == name; });
    return rotate_back(model.model_in_body.orientation,
                       Vec3d(angular_velocity_body(body_of(wheels, name).top).normalized()))
        .y();
  };
  CHECK(steadiness("tumbling") < 0.9);
  CHECK(steadiness("steady") > 0.999);

  // Of the wobbling disc the axis goes round |L| at |L|/I1, the disc at its spin about the axis.
  const Scene<double> disc = read_scene_file<double>(shipped("disc_and_coin"));
  const Top<double> flat = body_of(disc, "disc").top;
  const double wobble = flat.angular_momentum_body.norm() * flat.inverse_moments.maxCoeff(),
               spin = angular_velocity_world(flat).z();
  CHECK(std::abs(wobble / spin - 2) < 0.01);

  // One turn head over handle takes 2 pi/9 s.
  const Scene<double> racket = read_scene_file<double>(shipped("tennis_racket"));
  CHECK((axes_of(after(racket, 2 * std::numbers::pi / 9)) - Mat3d::Identity()).norm() < 0.2);
  CHECK(axes_of(after(racket, racket.duration))(1, 1) < -0.5);

  // From tail to tip, beside the velocity: 1 behind one another, 0 crosswise to level flight.
  const auto shaft = [&](const Scene<double>& scene) {
    return Vec3d(body_of(scene, "tip").centre.position - body_of(scene, "tail").centre.position)
        .normalized()
        .eval();
  };
  const Scene<double> dart = after(read_scene_file<double>(shipped("dart")), 1.5);
  CHECK(shaft(dart).dot(body_of(dart, "tip").centre.velocity.normalized()) > 0.95);
  std::ifstream file(shipped("dart"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  const std::string drag = "\"coefficient\": 0.000576";
  REQUIRE(text.find(drag) != std::string::npos);
  text.replace(text.find(drag), drag.size(), "\"coefficient\": 0");
  const Scene<double> airless = read_scene<double>(text, "airless.json");
  const Vec3d crosswise = shaft(airless);
  CHECK(distance(shaft(after(airless, 1.5)), crosswise) < 1e-9);

  // The rope holds the corner; it is slack where that is less than its metre away.
  Scene<double> crate = read_scene_file<double>(shipped("tethered_box"));
  const auto from_anchor = [&] {
    const Vec3d corner = axes_of(crate) * Vec3d(0.2, 0.15, 0.1);
    return Vec3d(body_of(crate, "crate").centre.position + corner - Vec3d(0, 0, 3));
  };
  bool went_slack = false;
  for (int n = 0; n < 240 * 300; ++n) {
    crate.world.step();
    went_slack |= from_anchor().norm() < 1;
  }
  CHECK(went_slack);
  CHECK(body_of(crate, "crate").centre.velocity.norm() < 1e-3);
  CHECK(from_anchor().head<2>().norm() < 1e-3);
}

TEST_CASE_TEMPLATE("The handle of the scene file is that of chapter 8", Real, EVERY_PRECISION) {
  const RigidBody<double> expected = thrown_t_handle().body;
  const Scene<Real> scene = read_scene_file<Real>(shipped("t_handle"));
  const RigidBody<Real> body = scene.world.body(scene.world.find("handle"));
  // A quarter turn by a quaternion is off by 4 roundings of double where a matrix of ones and zeros
  // is not; the tensor sees that twice. Float then rounds every number once.
  const double slack = 32 * unit_roundoff<double> + 2 * double(unit_roundoff<Real>);
  CHECK(double(body.centre.inverse_mass) ==
        doctest::Approx(expected.centre.inverse_mass).epsilon(slack));
  for (int axis = 0; axis < 3; ++axis)
    CHECK(double(body.top.inverse_moments[axis]) ==
          doctest::Approx(expected.top.inverse_moments[axis]).epsilon(slack));
  const Vec3d spin = angular_velocity_world(body.top).template cast<double>();
  CHECK(distance(spin, Vec3d(0.1, 10, 0)) <= 10 * 16 * double(unit_roundoff<Real>));
}

TEST_CASE_TEMPLATE("A thruster pushes where the file says, in the axes of the model", Real,
                   EVERY_PRECISION) {
  // Of this box the centre of mass lies 1 m above the model's origin, and its body axes are not
  // those of the model: they are ordered by the moments. A push of 6 N along x at the origin turns
  // it about −y. A quarter turn about z makes the model's x the world's y, and its −y the world's
  // x.
  const std::string text = scene_of(
      R"({"name": "box", "orientation": {"axis": [0, 0, 1], "angle": 1.5707963267948966},
          "solid": {"shape": "compound", "parts": [{"mass": 2, "position": [0, 0, 1],
            "solid": {"shape": "box", "size": [1, 2, 3]}}]}})",
      effect("thruster", R"("bodies": ["box"], "force": [6, 0, 0])"));
  Scene<Real> scene = read_scene<Real>(text, "box.json");
  const Posed& model = scene.models[0].model_in_body;
  REQUIRE(std::abs(model.orientation.real) < 0.9);
  scene.world.step();
  const RigidBody<Real> box = scene.world.body(scene.world.find("box"));
  const Real h = scene.world.time_step(), slack = 64 * unit_roundoff<Real>;
  CHECK(distance<Real>(box.centre.velocity, Vec3<Real>(0, 3 * h, 0)) <= slack * 3 * h);
  CHECK(distance<Real>(angular_momentum_world(box.top), Vec3<Real>(6 * h, 0, 0)) <= slack * 6 * h);
  CHECK(distance(inverse(model).position, Vec3d(0, 0, 1)) <= 8 * unit_roundoff<double>);
}

TEST_CASE_TEMPLATE("A spring holds the body where the file says, in the axes of the model", Real,
                   EVERY_PRECISION) {
  // The box lies turned by a quarter about z, so the model's point x = 1 is at y = 1 in the world,
  // 2 m from the anchor: 10 N/m pull with 20 N along y, and the arm along y feels no torque.
  const std::string text = scene_of(
      R"({"name": "box", "solid": {"shape": "box", "size": [1, 2, 3]}, "mass": 2,
          "orientation": {"axis": [0, 0, 1], "angle": 1.5707963267948966}})",
      effect("spring", R"("bodies": ["box"], "stiffness": 10, "anchor": [0, 3, 0],)"
                       R"( "attachment": [1, 0, 0])"));
  Scene<Real> scene = read_scene<Real>(text, "box.json");
  scene.world.step();
  const RigidBody<Real> box = scene.world.body(scene.world.find("box"));
  const Real h = scene.world.time_step(), slack = 64 * unit_roundoff<Real>;
  CHECK(distance<Real>(box.centre.velocity, Vec3<Real>(0, 10 * h, 0)) <= slack * 10 * h);
  CHECK(angular_momentum_world(box.top).norm() <= slack * 20 * h);
}

TEST_CASE_TEMPLATE("A part of a compound is turned as the file says", Real, EVERY_PRECISION) {
  // A third of a turn about (1, 1, 1) takes x to y, y to z and z to x: what was long along z lies
  // along x. The turn back would lay it along y.
  const std::string text =
      scene_of(R"({"name": "box", "solid": {"shape": "compound", "parts": [{"mass": 12,
          "solid": {"shape": "box", "size": [1, 2, 3]},
          "orientation": {"axis": [1, 1, 1], "angle": 2.0943951023931953}}]}})");
  const Scene<Real> scene = read_scene<Real>(text, "box.json");
  const Mat3<Real> inertia = world_inertia(scene.world.body(scene.world.find("box")).top);
  const Mat3<Real> expected = Vec3<Real>(1 + 4, 9 + 4, 9 + 1).asDiagonal();
  CHECK((inertia - expected).cwiseAbs().maxCoeff() <= 64 * unit_roundoff<Real> * 13);
}

TEST_CASE(
    "Copies stand where the rule of the page puts them, from an engine whose numbers the standard "
    "fixes") {
  // The standard fixes the engine by this number: its 10,000th, from its own seed.
  std::mt19937_64 engine;
  engine.discard(9999);
  CHECK(engine() == 9981545732273789042ULL);
  const Scene<double> rain = read_scene_file<double>(shipped("rain"), {.most_copies = 2});
  std::mt19937_64 numbers(7);
  const auto draw = [&](double low, double high) {
    return low + static_cast<double>(numbers() >> 11) / 9007199254740992.0 * (high - low);
  };
  for (const std::string name : {"drop 1", "drop 2"}) {
    const RigidBody<double> copy = rain.world.body(rain.world.find(name));
    const double x = draw(-50, 50), y = draw(-50, 50), z = draw(0, 100);
    CHECK(same_bits(copy.centre.position, Vec3d(x, y, z)));
    const double u = draw(-0.5, 0.5), v = draw(-0.5, 0.5), w = draw(-6, 0);
    CHECK(same_bits(copy.centre.velocity, Vec3d(u, v, w)));
  }
}

TEST_CASE("Random orientations are unit quaternions that prefer no direction") {
  PortableRandom random(1);
  const int count = 20'000;
  Vec3d mean = Vec3d::Zero();
  Mat3d squares = Mat3d::Zero();
  for (int n = 0; n < count; ++n) {
    const Quaternion<double> q = random.orientation();
    REQUIRE(std::abs(norm(q) - 1) <= 8 * unit_roundoff<double>);
    const Vec3d turned = rotate(q, Vec3d(0, 0, 1));
    mean += turned / count;
    squares += turned * turned.transpose() / count;
  }
  // A component has variance 1/3, its square 4/45, a product of two 1/15; five standard deviations.
  CHECK(distance(mean, Vec3d(0, 0, 0)) <= 5 * std::sqrt(1.0 / 3 / count));
  CHECK((squares - Mat3d::Identity() / 3).cwiseAbs().maxCoeff() <= 5 * std::sqrt(4.0 / 45 / count));
}

TEST_CASE(
    "Each mistake that we thought of in a scene file is said with the file, the place and the "
    "rule") {
  for (const BadScene& bad : bad_scenes()) {
    CAPTURE(bad.text);
    CHECK(complaint_of_scene<double>(bad.text) == bad.complaint);
  }
}

TEST_CASE("Nothing of a scene file that is shown gives orders to a terminal") {
  for (char32_t letter = 0; letter < 0x3000; ++letter) {
    const std::string text = utf8(letter);
    char escape[8];
    std::snprintf(escape, sizeof escape, "\\u%04x", unsigned(letter) & 0xffff);
    // Unicode's control characters, its ends of lines and paragraphs, and what turns a line round.
    const std::u32string others =
        U"\u061c\u200e\u200f\u2028\u2029\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069";
    const bool is_order = (letter < 0x20 && letter != '\n' && letter != '\t') ||
                          (letter >= 0x7f && letter < 0xa0) ||
                          others.find(letter) != std::u32string::npos;
    CAPTURE(unsigned(letter));
    CHECK(plain("a" + text + "b") ==
          (is_order ? std::string("a") + escape + "b" : "a" + text + "b"));
  }
  for (const std::string cut : {"\xc2", "\xe2", "\xe2\x80", "\xe2\x81"}) CHECK(plain(cut) == cut);
}

TEST_CASE("Numbers that fit a double but no float are refused in float alone") {
  for (const BadScene& bad : scenes_too_wide_for_float()) {
    CAPTURE(bad.text);
    CHECK(complaint_of_scene<float>(bad.text) == bad.complaint);
    CHECK(complaint_of_scene<double>(bad.text) == "nothing thrown");
  }
}

TEST_CASE("A scene that fails half-way leaves nothing behind") {
  const auto moved = [] {
    Scene<double> scene = read_scene<double>(scene_of(ball + ", " + drop), "good.json");
    for (int n = 0; n < 10; ++n) scene.world.step();
    return scene.world.bodies();
  };
  const Bodies<double> before = moved();
  for (const BadScene& bad : bad_scenes()) complaint_of_scene<double>(bad.text);
  CHECK(same_motion(before, moved()));
  CHECK(before.centres.size() == 2);
}

TEST_CASE("A file that is not there, or is a folder, is an error that names it") {
  for (const std::string path : {"nowhere/scene.json", "."})
    CHECK_THROWS_WITH_AS(read_scene_file<double>(path),
                         (path + ": there is no such file, or it can't be read").c_str(),
                         SceneError);
}

TEST_CASE("A scene is read from a file and stepped, and a mistake in one is told with its place") {
  const std::filesystem::path path = scenes_folder() / "t_handle.json";
  //! [read_scene_file.hpp read_scene.hpp scene.hpp]
  Scene<double> scene = read_scene_file<double>(path);
  const BodyHandle handle = scene.world.find("handle");
  while (scene.world.time() < 1) scene.world.step();  // s
  CHECK(energy_of(scene.world).turning > 0);          // J
  CHECK(scene.world.name_of(handle) == "handle");
  try {
    read_scene<double>(R"({"duration": 1, "bodies": [{"name": "stone"}]})", "mine.json");
  } catch (const SceneError& error) {
    CHECK(error.pointer == "/bodies/0");
  }
  //! [read_scene_file.hpp read_scene.hpp scene.hpp]
}
