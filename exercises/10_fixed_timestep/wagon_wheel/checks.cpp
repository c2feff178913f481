#include <exercise/judge.hpp>
#include <tumble/interpolation.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition numbers_of_spokes[] = {
    {"seen_turn", 1, 1, 12}, {"seen_rate", 1, 1, 12}, {"standing_rate", 0, 1, 12}};

constexpr double pictures = 16;

int spokes() {
  return static_cast<int>(parameter("spokes"));
}
double gap() {
  return 2 * std::numbers::pi / spokes();
}

template <class Real>
double seen_turn(double turn, int of) {
  return double(ask<Real>("seen_turn", Real(turn), of));
}

/// A turn is rounded on its way, and the gap, which is taken from it some times, is too.
template <class Real>
double tolerance(double turn) {
  return 8 * unit_roundoff<Real> * (std::abs(turn) + 1);
}

std::string wheel() {
  return "a wheel with " + std::to_string(spokes()) + " spokes";
}

}  // namespace

EXERCISE_CHECK("A small turn is seen as it is, forward and backward") {
  for (const double part : {0.0, 0.125, 0.375, -0.25, -0.4375}) {
    const double turn = double(Real(part * gap()));
    Found("the turn that is seen of " + wheel() + " that turns by " + shown(turn) + " rad", "rad",
          seen_turn<Real>(turn, spokes()))
        .mistake(turn + gap(),
                 "it went backward by less than half a gap, and it is seen so. Take the smallest "
                 "turn, not the smallest positive one")
        .mistake(-turn, "the turn is seen the other way round")
        .mistake(turn * 180 / std::numbers::pi,
                 "that is in degrees; all angles here are in radians")
        .must_be(turn, tolerance<Real>(turn));
    const double more = double(Real(turn + 2 * std::numbers::pi));
    Found("the turn that is seen of " + wheel() + " that turns by " + shown(more) + " rad", "rad",
          seen_turn<Real>(more, spokes()))
        .mistake(more, "after a whole turn the wheel looks as it did before")
        .mistake(turn + gap(),
                 "it went backward by less than half a gap, and it is seen so. Take the smallest "
                 "turn, not the smallest positive one")
        .must_be(turn, 2 * tolerance<Real>(more));
  }
}

EXERCISE_CHECK("A turn that lacks little of whole gaps is seen as a small turn backward") {
  for (const int gaps : {2, 7, 1}) {
    const double back = 0.125 * gap(), turn = double(Real(gaps * gap() - back));
    Found("the turn that is seen of " + wheel() + " that turns by " + shown(turn) +
              " rad, an eighth of a gap short of " + std::to_string(gaps) +
              (gaps == 1 ? " gap," : " gaps,"),
          "rad", seen_turn<Real>(turn, spokes()))
        .mistake(
            gap() - back,
            "it is nearly a gap forward. The picture is the same as after a small turn backward, "
            "and the eye takes the smaller of both: std::remainder, not std::fmod")
        .mistake(turn, "the spokes look alike, so the wheel looks the same after every gap")
        .mistake(std::remainder(turn, 2 * std::numbers::pi),
                 "only whole turns were taken away. The spokes look alike, so the wheel looks the "
                 "same after every gap")
        .mistake(std::remainder(turn, gap() / 2),
                 "half gaps were taken away. After half a gap a spoke stands where none was")
        .must_be(turn - gaps * gap(), tolerance<Real>(turn));
  }
}

EXERCISE_CHECK("With a single spoke it is what the chapter draws between two states") {
  const Vec3<Real> axis = Vec3<Real>::UnitY();
  for (const double turn : {1.0, 3.0, 3.5, 6.0, -4.0}) {
    Pose<Real> from, to;
    to.orientation = quaternion_of_rotation_vector<Real>(Real(turn) * axis);
    // An eighth of the way, so that it is a small turn, which no way of writing a turn folds.
    const auto part = interpolated<Real>(from, to, Real(0.125));
    const double drawn = 8 * double(rotation_vector_of(part.orientation).y());
    // Turn to quaternion and back, multiplied by eight: more than there is is sixteen roundings of
    // a full turn.
    Found("the turn that is seen of a wheel with a single spoke that turns by " + shown(turn) +
              " rad",
          "rad", seen_turn<Real>(turn, 1))
        .mistake(turn, "the chapter draws the shortest arc, which is never longer than half a turn")
        .must_be(drawn, 8 * 16 * unit_roundoff<Real> * 2 * std::numbers::pi);
  }
}

EXERCISE_CHECK(
    "A wheel that speeds up seems to stand still at every multiple of the standing rate, and there "
    "alone") {
  const double truth = gap() * pictures;
  const double standing = double(ask<Real>("standing_rate", spokes(), Real(pictures)));
  Found("the standing rate of " + wheel() + " at 16 pictures a second", "rad/s", standing)
      .mistake(gap() / pictures,
               "that is a gap divided by the pictures a second. In a second it turns by "
               "sixteen gaps")
      .mistake(
          2 * std::numbers::pi * pictures,
          "that is a whole turn in each picture. It stands still long before, since the spokes "
          "look alike")
      .mistake(truth / 2, "there each spoke stands in the middle of a gap: it flickers")
      .mistake(pictures / spokes(), "that is in turns a second, where rad/s is asked for")
      .must_be(truth, tolerance<Real>(truth));
  for (int eighths = 0; eighths <= 24; ++eighths) {
    const int left = ((eighths + 4) % 8 + 8) % 8 - 4;
    if (left == -4) continue;  // half a gap: forward and backward are as good
    const double rate = double(Real(truth * eighths / 8));
    Found("at " + shown(rate) + " rad/s the rate that is seen", "rad/s",
          double(ask<Real>("seen_rate", Real(rate), spokes(), Real(pictures))))
        .mistake(std::remainder(rate, gap()) + 0.0,
                 "the whole second was taken for one picture: the turn from picture to picture is "
                 "the rate divided by the pictures a second")
        .mistake(left * truth / 8 / pictures,
                 "that is what is seen from one picture to the next. A second has sixteen of them")
        .must_be(left * truth / 8, pictures * tolerance<Real>(rate / pictures));
  }
  Found("the standing rate at 25 pictures a second", "rad/s",
        double(ask<Real>("standing_rate", spokes(), Real(25))))
      .must_be(25 * gap(), tolerance<Real>(25 * gap()));
  const double quick = double(Real(25 * gap() * 1.25));
  Found("at " + shown(quick) + " rad/s and 25 pictures a second the rate that is seen", "rad/s",
        double(ask<Real>("seen_rate", Real(quick), spokes(), Real(25))))
      .must_be(quick - 25 * gap(), 25 * tolerance<Real>(quick / 25));
}
