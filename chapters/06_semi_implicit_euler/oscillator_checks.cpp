#include <support/checks.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A particle of 1 kg on a spring of 4 N/m, so that w = 2 rad/s. Powers of two, so that a step
/// rounds four times a component and no more: h F and the sum, h v and the sum.
template <class Real>
constexpr Real frequency = 2;

template <class Real>
Particle<Real> stretched_by_a_metre() {
  return make_particle(Real(1), Vec3<Real>(1, 0, 0));
}

template <class Real>
void gather_spring(Particle<Real>& particle) {
  clear_force(particle);
  add_force(particle, -frequency<Real> * frequency<Real> * particle.position);
}

/// v² + w²x² − h w² x v, twice the energy plus what the order of the step adds to it (m²/s²).
template <class Real>
Real invariant(const Particle<Real>& particle, Real time_step) {
  const Real v = particle.velocity.x(), wx = frequency<Real> * particle.position.x();
  return v * v + wx * wx - time_step * frequency<Real> * wx * v;
}

/// (v² + w²x²)/2, the energy of 1 kg (J).
template <class Real>
Real energy(const Particle<Real>& particle) {
  return invariant(particle, Real(0)) / 2;
}

/// How much longer than √invariant the vector (v, wx) can get, and how much a small change of it
/// can grow on the way. The invariant lies between (1 − wh/2) and (1 + wh/2) times v² + w²x².
template <class Real>
Real stretch(Real wh) {
  return 1 / std::sqrt(1 - wh / 2);
}

/// The angle by which a step advances the oscillation: 2 asin(wh/2).
template <class Real>
long double phase_per_step(Real wh) {
  return 2 * std::asin(static_cast<long double>(wh) / 2);
}

}  // namespace

TEST_CASE_TEMPLATE("Kick and drift keeps v² + ω²x² − hω²xv of an oscillator", Real,
                   EVERY_PRECISION) {
  const Real time_step = Real(0.05), wh = frequency<Real> * time_step;
  Particle<Real> particle = stretched_by_a_metre<Real>();
  const Real start = invariant(particle, time_step), start_energy = energy(particle);
  const int steps = sizeof(Real) == sizeof(float) ? 1000 : 1'000'000;
  // With S = √(v² + w²x²), a step changes v and wx by u S (1 + wh) each in rounding, and the
  // invariant by at most 2 S (1 + wh/2) times that. Reading it off costs some 6 roundings.
  const Real per_step = 4 * (1 + wh / 2) * (1 + wh) * stretch(wh) * stretch(wh);
  const Real bound = (per_step * Real(steps) + 6) * unit_roundoff<Real> * start;
  Real off = 0, energy_off = 0;
  for (int n = 0; n < steps; ++n) {
    gather_spring(particle);
    step(particle, time_step);
    off = std::max(off, std::abs(invariant(particle, time_step) - start));
    energy_off = std::max(energy_off, std::abs(energy(particle) - start_energy));
  }
  CHECK(off <= bound);
  CHECK(energy_off > 10 * bound);  // the energy itself is not what is kept
  CHECK(energy_off <= (wh / 2) * stretch(wh) * stretch(wh) * start_energy + bound);
}

TEST_CASE_TEMPLATE(
    "Released from rest the energy rises by (ωh/2)/(1 − ωh/2) at most, and doubles at ωh = 1", Real,
    EVERY_PRECISION) {
  for (const Real wh : {Real(0.125), Real(0.5), Real(1), Real(1.5), Real(1.875)}) {
    CAPTURE(wh);
    Particle<Real> particle = stretched_by_a_metre<Real>();
    const Real start = energy(particle);
    Real least = start, most = start;
    const int steps = 400;
    for (int n = 0; n < steps; ++n) {
      gather_spring(particle);
      step(particle, wh / frequency<Real>);
      least = std::min(least, energy(particle));
      most = std::max(most, energy(particle));
    }
    // A step rounds v and wx by (1 + wh) u S each, as for the invariant above.
    const Real rounding =
        Real(steps) * 4 * (1 + wh / 2) * (1 + wh) * stretch(wh) * stretch(wh) * unit_roundoff<Real>;
    CHECK(most <= start / (1 - wh / 2) * (1 + rounding));
    CHECK(least >= start / (1 + wh / 2) * (1 - rounding));
    if (wh == 1) CHECK(most == 2 * start);  // v = −w, x = −1 m after two steps
    // Elsewhere the walk comes near the ends of its ellipse, within the 400th part of a turn.
    if (wh == Real(0.125)) CHECK(most >= start / (1 - wh / 2) * Real(0.999));
  }
}

TEST_CASE_TEMPLATE("A step advances an oscillation by 2 arcsin(ωh/2), not by ωh", Real,
                   EVERY_PRECISION) {
  for (const Real time_step : {Real(0.05), Real(0.25), Real(0.5), Real(0.75), Real(0.95)}) {
    CAPTURE(time_step);
    const Real wh = frequency<Real> * time_step;
    const long double phase = phase_per_step(wh);
    Particle<Real> particle = stretched_by_a_metre<Real>();
    const int steps = 200;
    // Each step adds at most √2 u S (1 + wh), which the steps after it stretch at most by
    // √((1 + wh/2)/(1 − wh/2)). The reference rounds its angle.
    const Real per_step =
        std::sqrt(Real(2)) * (1 + wh) * stretch(wh) * std::sqrt((1 + wh / 2) / (1 - wh / 2));
    for (int n = 1; n <= steps; ++n) {
      gather_spring(particle);
      step(particle, time_step);
      const long double exact = std::cos((n + 0.5L) * phase) / std::cos(phase / 2);
      const Real bound = (per_step + 4 * stretch(wh) * Real(phase)) * Real(n) * unit_roundoff<Real>;
      REQUIRE(std::abs(Real(particle.position.x() - exact)) <= bound);
    }
  }
  CHECK(phase_per_step(Real(1)) > 1.04L);  // 4.7 percent too fast
}

TEST_CASE_TEMPLATE("An oscillator released at 1 m stays within 31.63 m at ωh = 1.999", Real,
                   EVERY_PRECISION) {
  const Real time_step = Real(1.999) / frequency<Real>, wh = frequency<Real> * time_step;
  Particle<Real> particle = stretched_by_a_metre<Real>();
  Real amplitude = 0;
  const int steps = 200;
  for (int n = 0; n < steps; ++n) {
    gather_spring(particle);
    step(particle, time_step);
    amplitude = std::max(amplitude, std::abs(particle.position.x()));
  }
  // x = cos((n + ½)φ)/cos(φ/2). Between π/2 ± (π − φ)/2 lies one of its extremes, so the largest of
  // the first 200 is within the cosine of that angle of 1/cos(φ/2).
  const Real limit = 1 / std::sqrt(1 - wh * wh / 4);
  const Real missed = 1 - std::cos((Real(3.14159265358979) - Real(phase_per_step(wh))) / 2);
  const Real rounding = Real(steps) * std::sqrt(Real(2)) * (1 + wh) * stretch(wh) *
                        std::sqrt((1 + wh / 2) / (1 - wh / 2)) * unit_roundoff<Real>;
  CHECK(amplitude <= limit + rounding);
  CHECK(amplitude >= limit * (1 - missed) - rounding);
  CHECK(amplitude <= Real(31.63));
  CHECK(limit > Real(31.62));
}

TEST_CASE_TEMPLATE("An oscillator grows by exp(2 arcosh(ωh/2)) a step beyond ωh = 2", Real,
                   EVERY_PRECISION) {
  for (const Real wh : {Real(2.001), Real(2.1), Real(3)}) {
    CAPTURE(wh);
    const Real time_step = wh / frequency<Real>;
    const Real growth = std::exp(2 * std::acosh(wh / 2));
    Particle<Real> particle = stretched_by_a_metre<Real>();
    // What does not grow dies out as fast as the rest grows. After these steps it is below u.
    const int steps = 20 + static_cast<int>(-std::log(unit_roundoff<Real>) / std::log(growth));
    for (int n = 0; n < steps; ++n) {
      gather_spring(particle);
      step(particle, time_step);
    }
    const Real before = particle.position.x();
    gather_spring(particle);
    step(particle, time_step);
    // Near the limit acosh(1 + s) = √(2s) magnifies the rounding of wh/2 by 1/√(2s). The step's own
    // four roundings act on terms up to growth² larger than the result.
    const Real magnified = 2 / std::sqrt(wh - 2);
    const Real bound = (magnified + 4 * growth * growth + 8) * growth * unit_roundoff<Real>;
    CHECK(std::abs(particle.position.x() / before + growth) <= bound);  // it flips sign as it grows
  }
}

TEST_CASE_TEMPLATE("Explicit Euler multiplies an oscillator's energy by 1 + h²ω² a step", Real,
                   EVERY_PRECISION) {
  const Real time_step = Real(0.05), wh = frequency<Real> * time_step;
  Particle<Real> particle = stretched_by_a_metre<Real>();
  const long double factor = 1 + static_cast<long double>(wh) * wh;
  const int steps = 1000;
  for (int n = 1; n <= steps; ++n) {
    gather_spring(particle);
    explicit_step(particle, time_step);
    const long double exact = std::pow(factor, n) * 2;  // w²/2 for the first metre
    // A step rounds v and wx by (1 + wh) u each relative to √(2E), so E by √8 (1 + wh) u. The
    // reference and the reading of E add some roundings of their own.
    const Real bound = (std::sqrt(Real(8)) * (1 + wh) + 1) * Real(n + 6) * unit_roundoff<Real>;
    REQUIRE(std::abs(Real(energy(particle) / exact - 1)) <= bound);
  }
  CHECK(energy(particle) > 40'000);
}

TEST_CASE_TEMPLATE("Kick and drift each keep the area of a triangle of starts", Real,
                   EVERY_PRECISION) {
  const Real time_step = Real(0.25), wh = frequency<Real> * time_step;
  const auto triangle = [] {
    std::array<Particle<Real>, 3> corners;
    for (Particle<Real>& corner : corners) corner = make_particle(Real(1), Vec3<Real>(1, 0, 0));
    corners[1].position.x() = Real(1.5);
    corners[2].velocity.x() = Real(0.75);
    return corners;
  };
  const auto area = [](const std::array<Particle<Real>, 3>& corner) {
    const Vec3<Real> along = corner[1].position - corner[0].position,
                     across = corner[1].velocity - corner[0].velocity,
                     along2 = corner[2].position - corner[0].position,
                     across2 = corner[2].velocity - corner[0].velocity;
    return (along.x() * across2.x() - along2.x() * across.x()) / 2;
  };
  const int steps = 100;
  // Each corner stays within |v| < 6 and |x| < 3, the sides as well. A step rounds every corner's v
  // and x by under 2 u times these; an area is made of products of two sides.
  const Real bound = Real(steps) * 2 * 2 * unit_roundoff<Real> * 6 * 3 * 4;
  auto kept = triangle(), gained = triangle();
  const Real start = area(kept);
  for (int n = 0; n < steps; ++n) {
    for (Particle<Real>& corner : kept) gather_spring(corner);
    for (Particle<Real>& corner : kept) kick(corner, time_step);
    CHECK(std::abs(area(kept) - start) <= bound);
    for (Particle<Real>& corner : kept) drift(corner, time_step);
    CHECK(std::abs(area(kept) - start) <= bound);
  }
  const int few = 10;
  for (int n = 0; n < few; ++n)
    for (Particle<Real>& corner : gained) {
      gather_spring(corner);
      explicit_step(corner, time_step);
    }
  // Ten explicit steps stretch every length by (1 + w²h²)^5, three for wh = 1/2.
  const Real grown = std::pow(1 + wh * wh, Real(few));
  CHECK(std::abs(area(gained) - start * grown) <= bound * grown);
}

TEST_CASE_TEMPLATE(
    "Under a force other than a spring's a step keeps areas too, and an explicit step does not",
    Real, EVERY_PRECISION) {
  // F = −4 x − x³. Four neighbours, 2 d apart in place and in velocity; the area of what becomes of
  // them by that of what they were. For one step that is exactly 1, however large d: the kick
  // differs by h (a(x + d) − a(x − d)) and the drift by h times that.
  const Real d = Real(0.0625), h = Real(0.125);
  const auto area = [&](Real x, Real v, const auto& rule) {
    const auto stepped = [&](Real x_start, Real v_start) {
      Particle<Real> particle =
          make_particle(Real(1), Vec3<Real>(x_start, 0, 0), Vec3<Real>(v_start, 0, 0));
      const Real pull = -4 * x_start - x_start * x_start * x_start;
      add_force(particle, Vec3<Real>(pull, 0, 0));
      rule(particle, h);
      return particle;
    };
    const auto right = stepped(x + d, v), left = stepped(x - d, v), up = stepped(x, v + d),
               down = stepped(x, v - d);
    return ((right.position.x() - left.position.x()) * (up.velocity.x() - down.velocity.x()) -
            (up.position.x() - down.position.x()) * (right.velocity.x() - left.velocity.x())) /
           (4 * d * d);
  };
  for (const Real x : {Real(-1.5), Real(0), Real(0.5), Real(2)})
    for (const Real v : {Real(-1), Real(0.75)}) {
      CAPTURE(x);
      // Places and velocities up to 4 are rounded some 8 times, and divided by 2 d.
      const Real rounding = 4 * 8 * 4 * unit_roundoff<Real> / (2 * d);
      CHECK(std::abs(area(x, v, step<Real>) - 1) <= rounding);
      // An explicit step makes it 1 − h² a', a' being −4 − 3 x² − d² between the neighbours.
      const Real gained = h * h * (4 + 3 * x * x + d * d);
      CHECK(std::abs(area(x, v, explicit_step<Real>) - 1 - gained) <= 2 * rounding);
    }
}

TEST_CASE_TEMPLATE("Beyond its stability limit a damped spring grows, just below it does not", Real,
                   EVERY_PRECISION) {
  struct Spring {
    Real stiffness, damping, mass;
  };
  for (const Spring& spring : {Spring{100, 0, 4}, Spring{100, 3, 4}, Spring{100, 40, Real(0.5)},
                               Spring{0, 8, 2}, Spring{1e5f, 0, 1}}) {
    CAPTURE(spring.damping);
    const Real limit = largest_stable_time_step(spring.stiffness, spring.damping, 1 / spring.mass);
    const auto grown = [&spring](Real time_step) {
      // Started with h v = x = 1, in units of the step.
      Particle<Real> particle =
          make_particle(spring.mass, Vec3<Real>(1, 0, 0), Vec3<Real>(1 / time_step, 0, 0));
      for (int n = 0; n < 200; ++n) {
        clear_force(particle);
        add_force(particle,
                  -spring.stiffness * particle.position - spring.damping * particle.velocity);
        step(particle, time_step);
      }
      return std::abs(particle.velocity.x()) * time_step;
    };
    // Below the limit nothing exceeds 1/√(1 − 0.99²) = 7.1 times its start, √5 here.
    CHECK(grown(Real(0.99) * limit) < 16);
    CHECK(grown(Real(1.01) * limit) > 16);
  }
  CHECK(largest_stable_time_step(Real(4), Real(0), Real(1)) == 1);          // 2/w
  CHECK(largest_stable_time_step(Real(0), Real(4), Real(1)) == Real(0.5));  // 2 m/c
  CHECK(std::isinf(largest_stable_time_step(Real(4), Real(4), Real(0))));
  // The squares of these two leave the range; their root does not. 4/(c/m + √((c/m)² + 4 k/m)).
  const Real huge = std::ldexp(Real(1), std::numeric_limits<Real>::max_exponent - 4);
  CHECK(largest_stable_time_step(Real(0), huge, Real(1)) == 2 / huge);
  const Real tiny = 1 / huge;
  CHECK(largest_stable_time_step(Real(0), tiny, Real(1)) == 2 / tiny);
  // And the product of these two leaves it, where the root of k/m, a power of two, does not.
  CHECK(largest_stable_time_step(huge, Real(0), huge) == 2 / huge);
  CHECK(largest_stable_time_step(tiny, Real(0), tiny) == 2 / tiny);
}

TEST_CASE_TEMPLATE("A stiffness, damping or inverse mass that cannot be is refused by name", Real,
                   EVERY_PRECISION) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const auto complaint = [](Real stiffness, Real damping, Real inverse_mass) {
    return complaint_of([=] { largest_stable_time_step(stiffness, damping, inverse_mass); });
  };
  CHECK(complaint(-1, 0, 1) == "stiffness is -1 N/m; it must be 0 or more");
  CHECK(complaint(1, -2, 1) == "spring's damping is -2 N s/m; it must be 0 or more");
  CHECK(complaint(1, 0, -3) == "inverse mass is -3 1/kg; it must be 0 or more");
  CHECK(complaint(nan, 0, 1) == "stiffness is nan N/m; it must be finite");
  CHECK(complaint(1, nan, 1) == "spring's damping is nan N s/m; it must be finite");
  CHECK(complaint(1, 0, nan) == "inverse mass is nan 1/kg; it must be finite");
}
