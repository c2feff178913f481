#include <exercise/judge.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
Real push(double height, double speed) {
  return ask<Real>("ground_push", Real(height), Real(speed));
}

template <class Real>
constexpr double few_roundings = 16 * unit_roundoff<Real>;

}  // namespace

EXERCISE_CHECK("At rest below the ground it is 4000 times the depth to the power of three halves") {
  for (const double depth : {0x1p-20, 0.01, 0.25, 4.0}) {
    const double d = double(Real(depth)), truth = 4000 * d * std::sqrt(d);
    Found("the push on a ball at rest " + shown(d) + " m below the ground", "N",
          double(push<Real>(-d, 0)))
        .mistake(-truth, "it is pulled down. Upward is positive")
        .mistake(4000 * std::sqrt(d),
                 "that is the root of the depth alone; d^(3/2) is d times its root")
        .mistake(4000 * d, "that is a spring, in proportion to the depth. Where is the root?")
        .mistake(4000 * d * d, "that is the depth squared")
        .mistake(
            0, "it is as if the ball were above the ground. Which side does the condition choose?")
        .not_a_number("the depth is -height; a negative number has no real root")
        .must_be(truth, few_roundings<Real> * truth);
  }
}

EXERCISE_CHECK("Above the ground nothing pushes: zero, and no NaN") {
  require(push<Real>(-0.25, 0) > 0,
          "below the ground nothing pushes either, so there is nothing to tell apart");
  for (const double height : {0.0, 1e-6, 0.25, 30.0}) {
    const Real found = push<Real>(height, 0);
    const std::string ball = "a ball at rest " + shown(height) +
                             " m above the ground is pushed with " + shown(found) + " N: ";
    require(
        !std::isnan(found),
        ball +
            "the root of a negative depth is NaN, and it got through. A choice drops it; a product "
            "with 0 does not, for 0 times NaN is NaN");
    require(!(found > 0), ball + "from afar, as if its height were a depth. Choose by the sign");
    require(!(found < 0), ball + "the ground attracts it. Choose by the sign of the height");
  }
}

EXERCISE_CHECK("What comes is braked, what goes is pushed less, and nothing is ever pulled") {
  const double at_rest = 500;  // 0.25 m below
  const auto look = [&](const char* how, double speed, double factor) {
    Found(std::string("0.25 m below the ground, the push on a ball that ") + how, "N",
          double(push<Real>(-0.25, speed)))
        .mistake(at_rest, "as on one at rest. Where does the speed come in?")
        .mistake(at_rest * (1 + speed / 2), speed < 0 && 1 + speed / 2 < 0
                                                ? "it is pulled down though it comes"
                                                : "what comes is pushed less and what goes more: "
                                                  "the ground would give energy. The sign "
                                                  "of the speed is turned round")
        .mistake(at_rest * (1 - speed / 2), "the ground holds on to it. A push can't be negative")
        .mistake(at_rest * (1 - speed), "only half of the speed counts: 1 - s/2")
        .must_be(at_rest * factor, few_roundings<Real> * at_rest * 2);
  };
  look("comes with 1 m/s", -1, 1.5);
  look("goes with 1 m/s", 1, 0.5);
  look("goes with 1.998 m/s", 2 - 0x1p-9, 0x1p-10);
  look("goes with 4 m/s", 4, 0);
  // At a quarter of a metre the root of the depth is the half of the speed's factor.
  for (const auto& [speed, truth] : {std::pair{-1.0, 48000.0}, {1.0, 16000.0}})
    Found("4 m below the ground, the push at a speed of " + shown(speed) + " m/s", "N",
          double(push<Real>(-4, speed)))
        .mistake(32000 * (1 - 2 * speed), "the part that the speed takes must not depend on depth")
        .must_be(truth, few_roundings<Real> * truth);
}

EXERCISE_CHECK(
    "Each ball of a pack gets the bits that it would get alone, whatever its neighbours do") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real infinity = std::numeric_limits<Real>::infinity();
  const std::vector<Real> heights = {Real(-0.1), Real(0.3),  Real(-2), 0,
                                     Real(0.5),  Real(-0.7), nan,      Real(-1),
                                     infinity,   Real(-1),   Real(-3), Real(1)};
  const std::vector<Real> speeds = {0, 1,        4, -1, Real(-0.5), Real(0.25),
                                    0, Real(-2), 0, 1,  Real(1.5),  3};
  const auto together = ask<std::vector<Real>>("pushes_in_packs", heights, speeds);
  require(together.size() == heights.size(),
          "twelve balls went in, and " + std::to_string(together.size()) + " pushes came out");
  Real least = infinity, most = -infinity;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const Real alone = push<Real>(double(heights[i]), double(speeds[i]));
    least = std::min(least, alone);
    most = std::max(most, alone);
    if (together[i] == alone || (std::isnan(together[i]) && std::isnan(alone))) continue;
    const std::string ball = sentence("ball ", i, " at ", heights[i], " m gets ", together[i],
                                      " N in a pack and ", alone, " N alone");
    require(alone != 0 && together[i] != 0,
            ball + ". Has another ball of its pack decided for it? A choice is made lane by lane");
    fail(ball +
         ". Equal operations in equal order give equal bits: is there a branch for packs alone?");
  }
  const Real first = push<Real>(double(heights[0]), double(speeds[0]));
  require(first > 1 && most > least,  // it is 126 N
          sentence("the pushes on twelve balls, above the ground and below it, are ", least, " to ",
                   most, " N, and ", first, " N at rest 0.1 m below it"));
}
