#include "three_suns.hpp"

#include <exercise/judge.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
std::vector<Particle<Real>> flown(Real time_step, int steps) {
  const auto end =
      ask<std::vector<Particle<Real>>>("flown", support::three_suns<Real>(), time_step, steps);
  require(end.size() == 3, "three bodies went in, and " + std::to_string(end.size()) + " came out");
  return end;
}

/// The worst distance from where a body began, after one period in so many steps.
template <class Real>
Real missed_by(int steps) {
  const auto start = support::three_suns<Real>();
  const auto end = flown(Real(support::period_of_the_eight / steps), steps);
  Real worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real miss = (end[i].position - start[i].position).norm();
    if (!(miss <= worst)) worst = miss;
  }
  return worst;
}

}  // namespace

EXERCISE_CHECK("A body pulls straight towards itself, with the product of the masses") {
  using Vector = Vec3<Real>;
  const auto on = make_particle(Real(2), Vector(1, 1, 0)),
             by = make_particle(Real(4), Vector(1, 5, 0));
  Found("the pull of 4 kg on 2 kg, four metres away along y,", "N", ask<Vector>("pull", on, by))
      .mistake(Vector(0, Real(-0.5), 0),
               "it pushes. The vector must lead from the body that is pulled to the one that pulls")
      .mistake(Vector(0, 2, 0),
               "right for one metre of distance. Does the length of r count once too often? "
               "r / |r|³ falls with the square of the distance")
      .mistake(Vector(0, Real(0.25), 0), "half of what it should be: is one of the masses missing?")
      .mistake(Vector(0, Real(0.125), 0),
               "a quarter of what it should be: is one of the masses missing?")
      .must_be(Vector(0, Real(0.5), 0), 16 * unit_roundoff<Real>);
}

EXERCISE_CHECK("Twice as far away, it pulls a quarter as hard") {
  using Vector = Vec3<Real>;
  const Vector direction(Real(0.48), Real(0.6), Real(-0.64));
  const auto on = make_particle(Real(3));
  const auto at = [&](Real distance) {
    return ask<Vector>("pull", on, make_particle(Real(5), Vector(distance * direction))).norm();
  };
  const Real near = at(1), far = at(2);
  Found("the pull from twice as far, as a part of the pull from near,", "", far / near)
      .mistake(Real(0.5),
               "it halves. The law is that of the inverse square; is a power of |r| missing?")
      .mistake(Real(0.125), "an eighth. |r|³ divides r, whose own length makes it the square")
      .mistake(1, "it is the same from everywhere. Where does the distance come in?")
      .mistake(2, "it grows with the distance, as a spring's pull would")
      .must_be(Real(0.25), 16 * unit_roundoff<Real>);
}

EXERCISE_CHECK("A step leaves the momentum of all three together as it was, and no force behind") {
  may_be_off() = 0.005;  // another rule's step of 1/16 s differs by some h²
  auto bodies = support::three_suns<Real>();
  for (int n = 0; n < 4; ++n) {
    bodies = ask<std::vector<Particle<Real>>>("step_all", bodies, Real(0.0625));
    require(bodies.size() == 3,
            "three bodies went in, and " + std::to_string(bodies.size()) + " came out");
    for (const Particle<Real>& body : bodies)
      require(body.force.isZero(0), "after a step the force " + shown(body.force) +
                                        " N is left. It would act again in the next: clear it");
  }
  const Vec3<Real> momentum = bodies[0].velocity + bodies[1].velocity + bodies[2].velocity;
  // The third begins at the origin with 1.3 m/s, and the others are a metre away.
  const Real moved = bodies[2].position.norm();
  require(moved > Real(0.1) && moved < 1,
          "after a quarter of a second the third body, which began with 1.3 m/s, is " +
              shown(moved) + " m from where it was. Does a step move every body?");
  require((bodies[2].velocity - support::three_suns<Real>()[2].velocity).norm() > Real(0.01),
          "after four steps the velocities are still those of the start. Does every body feel the "
          "others?");
  // Velocities and their changes stay below 4 m/s; six roundings a step and body are more than
  // there are.
  require(
      momentum.norm() <= 4 * 3 * 6 * 4 * unit_roundoff<Real>,
      "the momenta of all three sum to " + shown(momentum) +
          " N s instead of zero. Is a body moved before the others have felt its pull? First all "
          "forces, then all steps");
  auto unequal = support::three_suns<Real>();
  unequal[0].inverse_mass = Real(0.5);
  unequal[1].inverse_mass = Real(0.25);
  const auto total = [](const std::vector<Particle<Real>>& three) {
    Vec3<Real> sum = Vec3<Real>::Zero();
    for (const Particle<Real>& body : three) sum += body.velocity / body.inverse_mass;
    return sum;
  };
  const Vec3<Real> before = total(unequal);
  unequal = ask<std::vector<Particle<Real>>>("step_all", unequal, Real(0.0625));
  require(unequal.size() == 3,
          "three bodies went in, and " + std::to_string(unequal.size()) + " came out");
  // No momentum is above 8 N s; those of the three are summed before and after.
  Found("what a step adds to the momenta of three bodies of 2, 4 and 1 kg together", "N s",
        Vec3<Real>(total(unequal) - before))
      .must_be(Vec3<Real>::Zero(), 8 * 3 * 8 * unit_roundoff<Real>);
  // Three is the number of this lab and not of the function.
  auto four = support::three_suns<Real>();
  four.push_back(make_particle(Real(2), Vec3<Real>(0, 0, 2)));
  Vec3<Real> fallen = Vec3<Real>::Zero();
  for (int n = 0; n < 3; ++n) {
    const Vec3<Real> way = four[std::size_t(n)].position - four[3].position;
    fallen += Real(0.0625) * way / (four[std::size_t(n)].inverse_mass * std::pow(way.norm(), 3));
  }
  four = ask<std::vector<Particle<Real>>>("step_all", four, Real(0.0625));
  require(four.size() == 4,
          "four bodies went in, and " + std::to_string(four.size()) + " came out");
  // Three pulls below 1/4 m/s² each, with some twenty roundings.
  Found("the velocity of a fourth body, at rest 2 m above the three, after a step", "m/s",
        four[3].velocity)
      .mistake(Vec3<Real>::Zero(), "it feels nothing. How many bodies there are, the vector says")
      .must_be(fallen, 3 * 20 * unit_roundoff<Real>);
}

EXERCISE_CHECK(
    "After one period all three are back where they began, the nearer the shorter the step") {
  may_be_off() = 0.05;  // and along the whole period by some h
  const Real coarse = missed_by<Real>(250), fine = missed_by<Real>(500);
  // Who has never left is back, too. All three follow one path, a third of a period apart.
  const auto start = support::three_suns<Real>();
  const int third = 250;
  const auto then = flown(Real(support::period_of_the_eight / (3 * third)), third);
  for (std::size_t i = 0; i < 3; ++i) {
    Real nearest = std::numeric_limits<Real>::infinity();
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j) nearest = std::min(nearest, (then[i].position - start[j].position).norm());
    require(nearest < Real(0.1), "after a third of the period a body is " + shown(nearest) +
                                     " m from where another began; it must be there by then");
  }
  // First order: half the step, half the miss. The next order changes the ratio by some percent.
  require(fine < Real(0.1),
          "after one period a body is " + shown(fine) +
              " m from where it began: the three don't follow the figure of eight");
  require(coarse > Real(1.8) * fine, sentence("with half the step the miss went from ", coarse,
                                              " to ", fine, " m; it must be half or less"));
}
