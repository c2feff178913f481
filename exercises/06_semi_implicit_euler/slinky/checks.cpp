#include "a_slinky.hpp"

#include <exercise/judge.hpp>
#include <tumble/particle.hpp>

using namespace tumble;
using namespace tumble::exercise;
using support::Slinky;

namespace {

const Precondition number_of_beads("hung_up", 0, 2, 30);

template <class Real>
using Beads = std::vector<Particle<Real>>;

template <class Real>
Real height_of_centre(const Beads<Real>& beads) {
  Real sum = 0;
  for (const Particle<Real>& bead : beads) sum += bead.position.z();
  return sum / Real(beads.size());
}

/// The judge's own slinky in balance.
template <class Real>
Beads<Real> hanging() {
  Beads<Real> beads;
  double height = 0;
  for (int i = 0; i < Slinky::beads; ++i) {
    beads.push_back(make_particle(Real(Slinky::mass), Vec3<Real>(0, 0, Real(height))));
    height -= Slinky::closed +
              (Slinky::beads - 1 - i) * Slinky::mass * Slinky::gravity / Slinky::stiffness;
  }
  return beads;
}

/// For how long the lower end hovers, s: until the centre has fallen down to where it is.
double hovering_time() {
  const auto beads = hanging<double>();
  return std::sqrt(2 * (height_of_centre(beads) - beads.back().position.z()) / Slinky::gravity);
}

const int steps_a_second = 960;

template <class Real>
Beads<Real> fallen(int steps) {
  const auto beads =
      ask<Beads<Real>>("dropped", hanging<Real>(), Real(Slinky::stiffness), Real(Slinky::closed),
                       Real(Slinky::gravity), Real(1) / steps_a_second, steps);
  require(beads.size() == Slinky::beads,
          "24 beads went in, and " + std::to_string(beads.size()) + " came out");
  return beads;
}

}  // namespace

EXERCISE_CHECK("A spring pulls by what it is longer than closed, along itself") {
  using Vector = Vec3<Real>;
  const Real mass = Real(Slinky::mass), k = Real(Slinky::stiffness), closed = Real(Slinky::closed);
  const Vector way(Real(0.24), Real(0.3), Real(-0.32)), along = way / Real(0.5);
  const auto upper = make_particle(mass, Vector(1, 2, 3)),
             lower = make_particle(mass, Vector(Vector(1, 2, 3) + way));
  const Vector truth = k * (Real(0.5) - closed) * along;
  // The way between places near 3 rounds as they do.
  const double tolerance = double(k) * 16 * 4 * unit_roundoff<Real>;
  Found("the force of a spring of half a metre on its upper bead", "N",
        ask<Vector>("spring_force", upper, lower, k, closed))
      .mistake(-truth, "it pushes the upper bead up. A stretched spring pulls its ends together")
      .mistake(k * way, "the spring is 0.0025 m long when nothing pulls; only what is more counts")
      .mistake(k * (Real(0.5) - closed) * way,
               "the way is 0.5 m long itself. Divide by its length to keep the direction only")
      .mistake((Real(0.5) - closed) * along, "the stiffness is missing")
      .must_be(truth, tolerance);
}

EXERCISE_CHECK("Hung up, each spring carries the beads below it") {
  // The second is another slinky, on the Moon.
  struct Hung {
    int count;
    double mass, stiffness, closed, gravity;
  };
  for (const auto& [count, mass, stiffness, closed, gravity] :
       {Hung{Slinky::beads, Slinky::mass, Slinky::stiffness, Slinky::closed, Slinky::gravity},
        Hung{3, 0.03, 2, 0.005, 1.62}}) {
    const auto beads = ask<Beads<Real>>("hung_up", count, Real(mass), Real(stiffness), Real(closed),
                                        Real(gravity));
    require(int(beads.size()) == count,
            "asked for " + std::to_string(count) + " beads, got " + std::to_string(beads.size()));
    const double one = mass * gravity / stiffness;
    for (int i = count - 2; i >= 0; --i) {
      const auto at = [&](int n) { return beads[std::size_t(n)].position.z(); };
      const auto length = [&, rest = closed](double carried) { return Real(rest + carried * one); };
      Found("of " + std::to_string(count) + " beads, the length of the spring below number " +
                std::to_string(i + 1),
            "m", at(i) - at(i + 1))
          .mistake(-length(count - 1 - i), "it hangs upward. z points up, so the beads go down")
          .mistake(length(count - 1 - i) - Real(closed),
                   "that is what it is stretched by. It is also as long as a closed spring")
          .mistake(Real(closed), "it is closed, as if nothing hung on it")
          .mistake(length(count - i),
                   "it carries one bead too many: a bead hangs on the spring above it")
          .mistake(length(count), "it carries all beads. Those above it hang on other springs")
          .mistake(length(i + 1), "it carries the beads above it. They hang on other springs")
          .mistake(length(i), "it carries the beads above it. They hang on other springs")
          .must_be(length(count - 1 - i), double(4 * count) * unit_roundoff<Real>);
    }
  }
}

EXERCISE_CHECK("Let go, the slinky's centre falls as a stone does") {
  const double h = 1.0 / steps_a_second, from = height_of_centre(hanging<double>());
  for (const int steps : {1, 96, 384}) {
    const auto beads = fallen<Real>(steps);
    const double t = steps * h, stone = -Slinky::gravity * (t * t + h * t) / 2;
    const auto place = [&](double fall) { return Real(from + fall); };
    Found("the height of the centre " + shown(t) + " s after the slinky was let go", "m",
          height_of_centre(beads))
        .mistake(place(0), "it has not fallen at all. Is gravity among the forces?")
        .mistake(place(stone * (Slinky::beads + 1) / 2.0),
                 "it is torn down. A spring pulls at both its ends: what the upper one gets, does "
                 "the lower one get it with a minus?")
        .mistake(place(2 * stone), "it falls twice as fast as a stone. Does gravity come in twice?")
        .mistake(place(-Slinky::gravity * (t * t - h * t) / 2),
                 "the drift came before the kick. Chapter 6 wants them the other way round")
        .must_be(place(stone), double(steps * 16 * 2) * unit_roundoff<Real>);
    for (const Particle<Real>& bead : beads) {
      require(bead.force.isZero(0), "after a step the force " + shown(bead.force) +
                                        " N is left. It would act again in the next: clear it");
      require(bead.position.x() == 0 && bead.position.y() == 0,
              "a bead is at " + shown(bead.position) +
                  " m. Nothing pulls it sideways: gravity is along minus z");
    }
  }
  const int steps = 96;
  const auto on_the_moon =
      ask<Beads<Real>>("dropped", hanging<Real>(), Real(Slinky::stiffness), Real(Slinky::closed),
                       Real(1.62), Real(1) / steps_a_second, steps);
  require(!on_the_moon.empty(), "24 beads went in, and none came out");
  const double t = steps * h, fall = (t * t + h * t) / 2;
  Found("the height of the centre when it is let go where things fall with 1.62 m/s²", "m",
        height_of_centre(on_the_moon))
      .mistake(Real(from - Slinky::gravity * fall),
               "it falls as on Earth. The step is told how strong gravity is")
      .must_be(Real(from - 1.62 * fall), double(steps * 16 * 2) * unit_roundoff<Real>);
}

EXERCISE_CHECK("The lowest coil hovers until the others have come down to it") {
  const auto start = hanging<Real>();
  const Real lower_end = start.back().position.z();
  const double time = hovering_time();
  const auto late = fallen<Real>(int(0.9 * time * steps_a_second));
  const Real fallen_by = lower_end - late.back().position.z();
  // By the springs alone it has been told n g t² (w t)^(2n-2) / (2n)! m by then, less than 1e-8.
  // The springs' lengths are rounded, and so each bead is pulled by that much too little or too
  // much.
  const double rounding =
      time * time / 2 * Slinky::stiffness / Slinky::mass * 4 * 1.2 * double(unit_roundoff<Real>);
  require(
      std::abs(double(fallen_by)) < 1e-8 + rounding,
      sentence("the lower end has ", fallen_by < 0 ? "risen by " : "fallen by ",
               std::abs(double(fallen_by)), " m after nine tenths of the ", time,
               " s. Nothing has reached it yet: in balance it has no reason to move. Has it its "
               "weight and the pull of its spring, both?"));
  const Real top = late.front().position.z();
  require(top < lower_end * Real(0.8),
          sentence("after nine tenths of the ", time, " s the upper end is at ", top,
                   " m. It should have come down nearly to the lower end, at ", lower_end, " m"));
  const auto after = fallen<Real>(int(1.1 * time * steps_a_second));
  require(after.back().position.z() < lower_end - Real(0.01),
          "after the " + shown(time) + " s the lower end still hovers. Do the coils meet it?");
}

EXERCISE_CHECK("No coil passes through another") {
  for (const double part : {0.2, 0.5, 0.8, 1.0}) {
    const auto beads = fallen<Real>(int(part * hovering_time() * steps_a_second));
    require(beads.front().position.z() < -Real(Slinky::closed),
            "the upper end is still at " + shown(beads.front().position.z()) +
                " m, where it was let go: nothing has come near anything");
    // The first spring carries all beads but one, and is closed first.
    const auto first_gap = [](const Beads<Real>& row) {
      return row[0].position.z() - row[1].position.z();
    };
    require(first_gap(beads) < first_gap(hanging<Real>()) / 2,
            "the upper two coils are still " + shown(first_gap(beads)) +
                " m apart: it falls as if it were stiff. Their spring pulls them together");
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
      const Real gap = beads[i].position.z() - beads[i + 1].position.z();
      require(gap > 0, sentence("coil ", i + 1, " is ", -gap,
                                " m below the next: it has fallen through it. "
                                "Call keep_apart between kick and drift"));
      // Its sweeps leave a part of the blows undone, less than a tenth of a closed spring.
      require(
          gap > Real(0.9 * Slinky::closed),
          sentence("coil ", i + 1, " is ", gap, " m above the next, nearer than a closed spring, ",
                   Slinky::closed, " m. Does keep_apart stand between kick and drift?"));
    }
  }
}
