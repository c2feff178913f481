#include <nlohmann/json.hpp>
#include <random>
#include <reference.hpp>
#include <support/checks.hpp>
#include <thread>
#include <tumble/scene/read_scene.hpp>

using namespace tumble;
using namespace tumble::advise;

namespace {

/// A box of 1 kg whose thruster pushes at a right angle to its arm, with times in s.
struct Burn {
  double from, until, force;
  Vec3d spin;

  std::string text() const {
    const auto number = [](double value) { return nlohmann::json(value).dump(); };
    return R"({"title": "a burn", "duration": 2, "bodies": [{"name": "box", "density": 250,
      "solid": {"shape": "box", "size": [0.1, 0.2, 0.2]}, "angular_velocity": [)" +
           number(spin.x()) + "," + number(spin.y()) + "," + number(spin.z()) +
           R"(]}], "effects": [{"kind": "thruster", "bodies": ["box"], "point": [0, 0.1, 0],
      "force": [)" +
           number(force) + R"(, 0, 0], "from": )" + number(from) + R"(, "until": )" +
           number(until) + "}]}";
  }

  /// How far the box has turned at such a time, by the classical rule of Runge and Kutta for
  /// Euler's equations, whose torque is constant in each of the three pieces.
  Quaterniond turned_at(double end) const {
    const Vec3d moments(0.08 / 12, 0.05 / 12, 0.05 / 12);
    struct State {
      Vec3d momentum;
      Eigen::Vector4d turn;  // x, y, z and the real part
    };
    State now{moments.cwiseProduct(spin), {0, 0, 0, 1}};
    const auto carry = [&](double time, const Vec3d& torque) {
      const auto rate = [&](const State& at) {
        const Vec3d w = at.momentum.cwiseQuotient(moments), v = at.turn.head<3>();
        State made{at.momentum.cross(w) + torque, {}};
        made.turn << (at.turn[3] * w + v.cross(w)) / 2, -v.dot(w) / 2;
        return made;
      };
      const auto moved = [](const State& at, const State& slope, double by) {
        return State{at.momentum + by * slope.momentum, at.turn + by * slope.turn};
      };
      constexpr int steps = 20'000;
      const double h = time / steps;
      for (int n = 0; n < steps; ++n) {
        const State a = rate(now), b = rate(moved(now, a, h / 2)), c = rate(moved(now, b, h / 2)),
                    d = rate(moved(now, c, h));
        for (const auto& [slope, part] : {std::pair(a, 1), {b, 2}, {c, 2}, {d, 1}})
          now = moved(now, slope, part * h / 6);
      }
    };
    carry(std::min(end, from), Vec3d::Zero());
    if (end > from) carry(std::min(end, until) - from, {0, 0, -0.1 * force});
    if (end > until) carry(end - until, Vec3d::Zero());
    return normalized(Quaterniond{now.turn[3], now.turn.head<3>()});
  }
};

constexpr Frames one_state{.count = 2, .rate = 1}, sixty_states{.count = 120, .rate = 60};

Scene<double> scene_of(const std::string& text, const StepLength& step) {
  return read_scene_text<double, OneByOne<double>>(text, "a burn",
                                                   {.step = step, .scheme = Scheme::suzuki},
                                                   turning_method_words<FirstTurningRules>());
}

/// How far the reference's last orientation is off.
double off(const Burn& burn, const Reference& reference) {
  const Quaterniond start = scene_of(burn.text(), {}).world.bodies().tops[0].orientation;
  return angle_between(reference.snapshots.back().orientations[0] * conjugate(start),
                       burn.turned_at(2));
}

Reference reference_for(const Burn& burn, const Frames& frames) {
  return reference_of([&](const StepLength& step) { return scene_of(burn.text(), step); }, frames,
                      {.angle = 0.01}, 10);
}

}  // namespace

TEST_CASE("The adviser's reference of a short burn is no further off than it says") {
  std::mt19937_64 generator(1);
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  std::vector<Burn> burns = {{1.0, 1.004, 250, Vec3d::Zero()},
                             {0, 1 / 60.0, 10, Vec3d::Zero()},
                             {0, std::nextafter(1 / 60.0, 1.0), 10, Vec3d::Zero()}};
  for (int n = 0; n < 24; ++n) {
    const double from = random(0, 1.9), lasts = random(0.001, 0.05);
    burns.push_back({from, from + lasts, 1 / lasts, {random(-2, 2), random(-2, 2), random(-2, 2)}});
  }
  for (const Burn& burn : burns)
    for (const Frames& frames : {one_state, sixty_states}) {
      CAPTURE(burn.from);
      CAPTURE(burn.until);
      CAPTURE(frames.rate);
      const Reference reference = reference_for(burn, frames);
      // The witness has 60,000 steps, each of which rounds.
      CHECK(off(burn, reference) <= reference.uncertainty.angle + 60'000 * 0x1p-53);
      CHECK(reference.uncertainty.angle <= 0.02 * 0.01);
    }
}

TEST_CASE("Two runs whose errors fall as a power of the step extrapolate to no error") {
  const Vec3d place(1, 2, 3), axis = Vec3d(2, -1, 2) / 3;
  const auto run = [&](double error) {
    advise::Snapshot snapshot;
    snapshot.places = {place + error * axis};
    snapshot.orientations = {quaternion_of_rotation_vector<double>(axis) *
                             quaternion_of_rotation_vector<double>(error * Vec3d(0, 0.6, 0.8))};
    return std::vector<advise::Snapshot>{snapshot};
  };
  for (const int order : {1, 2, 4, 10})
    for (const double ratio : {1.5, 2.0}) {
      const double error = 0.1;
      const auto estimate =
          extrapolated(run(error), run(error / std::pow(ratio, order)), ratio, order);
      const Errors off = errors_between(estimate, run(0));
      // Numbers up to 4, some twenty roundings; the rest is at most 2 times a difference of 0.1.
      CHECK(off.place <= 80 * 0x1p-53);
      CHECK(off.angle <= 80 * 0x1p-53);
    }
}

TEST_CASE("A run that ends in no number differs from the truth by more than anybody wants") {
  const advise::Snapshot truth{{Vec3d(1, 2, 3)}, {Quaterniond{1, Vec3d::Zero()}}};
  advise::Snapshot nowhere = truth, unturned = truth;
  nowhere.places[0].y() = NAN;
  unturned.orientations[0].real = NAN;
  CHECK(errors_between({truth}, {truth}).of({.angle = 1e-300, .place = 1e-300}) == 0);
  CHECK(errors_between({nowhere}, {truth}).of({.angle = 3}) == INFINITY);
  CHECK(errors_between({unturned}, {truth}).of({.place = 3}) == INFINITY);
  CHECK(Errors{.angle = NAN}.of({.angle = 3, .place = 3}) == INFINITY);
  CHECK(Errors{.place = NAN}.of({.angle = 3, .place = 3}) == INFINITY);
}

TEST_CASE("The order of a fall is that power, and no fall is none") {
  for (const std::array<long, 3>& steps : {std::array{1L, 2L, 3L}, {2, 3, 5}, {55, 89, 144}})
    for (int order = 1; order <= 10; ++order) {
      const auto error = [&](std::size_t n) {
        return std::pow(static_cast<double>(steps[n]), -order);
      };
      CHECK(order_of_fall(error(0) - error(1), error(1) - error(2), steps) == order);
    }
  CHECK(order_of_fall(1e-3, 0.9e-3, {2, 3, 5}) == 1);
  CHECK(order_of_fall(1e-3, 2e-3, {2, 3, 5}) == 1);
  CHECK(order_of_fall(1e-3, 0, {2, 3, 5}) == 1);
  CHECK(order_of_fall(0, 1e-3, {2, 3, 5}) == 1);
}

TEST_CASE("A scene is compared at a hundred states at most, the last of them at the end") {
  for (const long count : {1L, 7L, 100L, 101L, 250L, 12'345L}) {
    const Frames frames{.count = count};
    long compared = 0, last = 0, longest_gap = 0;
    for (long frame = 1; frame <= count; ++frame) {
      if (!is_compared(frame, frames)) continue;
      ++compared;
      longest_gap = std::max(longest_gap, frame - std::exchange(last, frame));
    }
    CAPTURE(count);
    CHECK(compared <= 100);
    CHECK(last == count);
    CHECK(longest_gap <= (count + 99) / 100);
  }
}

TEST_CASE("No run of the reference is begun that would take longer than a run may") {
  long longest = 0;
  // Each run lasts 10 ms for each step a frame, at least: the fourth one, with 5 steps, 50 ms.
  const auto sleepy = [&](const StepLength& step) {
    const long steps = std::lround(1 / time_step_of<double>(step));
    longest = std::max(longest, steps);
    std::this_thread::sleep_for(std::chrono::milliseconds(10 * steps));
    return scene_of(Burn{0, 0, 0, {1, 2, 3}}.text(), step);
  };
  (void)reference_of(sleepy, one_state, {.angle = 1e-300}, 0.04);
  CHECK(longest <= 3);
}

TEST_CASE("What two runs differ by in their angles tells the reference the order of the fall") {
  const std::string text = R"({"duration": 2, "bodies": [{"name": "box", "mass": 1,
      "inertia": [1, 2, 2.5], "angular_velocity": [1, 2, 0.5]}]})";
  const Reference reference = reference_of(
      [&](const StepLength& step) { return scene_of(text, step); }, one_state, {.angle = 1e-8}, 10);
  CHECK(reference.steps[1] <= 89);  // 34; if every fall were taken for one of first order, 233
}

TEST_CASE("Two extrapolations that agree by chance are not enough for a reference") {
  // A point at rest, with another place in the first run: the later ones are at 1 m, and so are the
  // extrapolations of 2 and 3 steps a frame, of 3 and 5, and of 5 and 8. That of 1 and 2 is at 2 m.
  const auto by_chance = [](const StepLength& step) {
    const std::string x = time_step_of<double>(step) == 1 ? "0" : "1";
    return scene_of(
        R"({"duration": 2, "bodies": [{"name": "a", "mass": 1, "position": [)" + x + ", 0, 0]}]}",
        step);
  };
  const Reference reference = reference_of(by_chance, one_state, {.place = 1e-3}, 10);
  CHECK(reference.steps == std::array{5L, 8L});
  CHECK(reference.uncertainty.place == 0);
}

TEST_CASE(
    "In whatever order a file names the burns, the reference cuts its steps at each of them") {
  const auto burn = [](const char* from, const char* until) {
    return R"({"kind": "thruster", "bodies": ["box"], "point": [0, 0.1, 0], "force": [20, 0, 0],
      "from": )" +
           std::string(from) + R"(, "until": )" + until + "}";
  };
  const std::string first = burn("0.31", "0.33"), second = burn("1.47", "1.52");
  const auto reference = [&](const std::string& effects) {
    return reference_of(
        [&](const StepLength& step) {
          return scene_of(R"({"duration": 2, "bodies": [{"name": "box", "density": 250, "solid":
            {"shape": "box", "size": [0.1, 0.2, 0.2]}}], "effects": [)" +
                              effects + "]}",
                          step);
        },
        one_state, {.angle = 0.01}, 10);
  };
  const Reference in_order = reference(first + "," + second),
                  swapped = reference(second + "," + first);
  CHECK(swapped.steps == in_order.steps);
  CHECK(errors_between(swapped.snapshots, in_order.snapshots).angle <= 1e-9);
}
