#include <support/checks.hpp>
#include <support/exact_motion.hpp>
#include <support/own_steps.hpp>
#include <support/rules.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Wide = long double;

}  // namespace

TEST_CASE_TEMPLATE(
    "An integration ends where it is told to, and no step goes beyond, but for two roundings", Real,
    EVERY_PRECISION) {
  const auto problem = heavy_top<Real>("", 3);
  using Forces = Weight<Real>;
  for (const Real seconds : {Real(0.1), Real(1) / 3, Real(7)}) {
    EmbeddedSteps<DormandPrince54, Top<Real>, Forces, Real> steps(
        problem.start, problem.evaluate_forces, Real(0), Real(1e-3));
    Real reached = 0, shortest = seconds;
    const StepCounts counts =
        integrate_adaptively(steps, seconds, Real(0.05), [&](Real gone, Real h) {
          CHECK(gone + h <= seconds * (1 + 2 * unit_roundoff<Real>));
          reached = gone + h;
          shortest = std::min(shortest, h);
        });
    CHECK(std::abs(reached - seconds) <= 2 * unit_roundoff<Real> * seconds);
    CHECK(shortest > seconds / 1000);  // no tiny step is left for the end
    CHECK(counts.steps > 0);
  }
  Particle<Real> still = make_particle<Real>(1, {1, 2, 3}, {4, 5, 6});
  const auto push = [](Particle<Real>& particle, Real) { particle.force = {1, 0, 0}; };
  const StepCounts none =
      integrate<DormandPrince54>(still, push, Real(0), 0, {Real(1e-3), Real(1e-3)});
  CHECK(none.steps == 0);
  CHECK(same_bits(still.position, Vec3<Real>(1, 2, 3)));
}

TEST_CASE_TEMPLATE("A step that is not accepted leaves no trace", Real, EVERY_PRECISION) {
  const auto orbit = eccentric_orbit<Real>();
  using Steps = EmbeddedSteps<DormandPrince54, Particle<Real>, Star<Real>, Real>;
  Steps patient(orbit.start, orbit.evaluate_forces, Real(0), {Real(1e-3), Real(1e-3)}),
      hasty = patient;
  CHECK(hasty.attempt(Real(3)) > 1);
  hasty.attempt(Real(0.01));
  patient.attempt(Real(0.01));
  hasty.accept();
  patient.accept();
  CHECK(same_bits(hasty.body().position, patient.body().position));
  CHECK(same_bits(hasty.body().velocity, patient.body().velocity));
}

TEST_CASE("Within a step the state errs by the order of the pair's curve, and meets both ends") {
  auto orbit = eccentric_orbit<Wide>();
  orbit.start = make_particle<Wide>(1, {0.8L, 0, 0}, {0, std::sqrt(1.5L), 0});  // e = 0.2
  const auto error = [&]<class Pair>(Pair, Wide h) {
    EmbeddedSteps<Pair, Particle<Wide>, Star<Wide>, Wide> steps(orbit.start, orbit.evaluate_forces,
                                                                0, {1, 1});
    steps.attempt(h);
    CHECK((steps.within(0).position - orbit.start.position).norm() <= 1e-18L);
    const Wide part = 0.4L;
    const auto truth = exactly_after(orbit.evaluate_forces, orbit.start, part * h);
    const Wide within = (steps.within(part).position - truth.position).norm();
    const Particle<Wide> end = steps.within(1);
    steps.accept();
    CHECK((end.position - steps.body().position).norm() <= 1e-18L);
    CHECK((end.velocity - steps.body().velocity).norm() <= 1e-18L);
    return within;
  };
  // In one step an order p errs by h^(p + 1).
  const Wide fifth = std::log2(error(DormandPrince54(), 0.02L) / error(DormandPrince54(), 0.01L)),
             eighth = std::log2(error(DormandPrince853(), 0.1L) / error(DormandPrince853(), 0.05L));
  CAPTURE(double(fifth));
  CAPTURE(double(eighth));
  // The next power of the step may add to it a part that halves with h.
  CHECK(std::abs(fifth - 5) < 0.3L);
  CHECK(std::abs(eighth - 8) < 0.5L);
}

TEST_CASE_TEMPLATE(
    "An integration of no time leaves a planet where it is, to the bit, and a top but for rounding",
    Real, EVERY_PRECISION) {
  const auto orbit = eccentric_orbit<Real>();
  Particle<Real> planet = orbit.start;
  CHECK(integrate<DormandPrince54>(planet, orbit.evaluate_forces, Real(0), 0,
                                   {Real(1e-3), Real(1e-3)})
            .steps == 0);
  CHECK(same_bits(planet.position, orbit.start.position));
  carry_in_transformed_time<Verlet>(planet, orbit.evaluate_forces, 0, 100);
  CHECK(same_bits(planet.position, orbit.start.position));
  CHECK(same_bits(planet.velocity, orbit.start.velocity));
  const Top<Real> start = free_problems<Real>()[0].start;
  Top<Real> top = start;
  integrate_free_top<DormandPrince54>(top, 0, Real(1e-3));
  CHECK(distance(top.orientation.imaginary, start.orientation.imaginary) <=
        16 * unit_roundoff<Real>);  // l is made a unit vector, and the turn to it undone
}

TEST_CASE("What an integration can't be asked for is refused") {
  Topd top = top_of<double>(tumbling_problems[0]);
  CHECK(complaint_of([&] { integrate_free_top<DormandPrince54>(top, -1, 1e-3); }) ==
        "time is -1 s; it must be 0 or more");
  CHECK(complaint_of([&] { integrate_free_top<DormandPrince54>(top, 1, 0); }) ==
        "tolerance is 0 a second; it must be greater than 0");
  const Weight<double> weight{1};
  CHECK(complaint_of([&] {
          integrate_axis<DormandPrince54>(top, weight, 0.0, 1, 1e-3);
        }).find("two of them must be equal") != std::string::npos);
  Topd heavy = heavy_top<double>("", 3).start;
  CHECK(complaint_of([&] { integrate_axis_evenly<Kutta>(heavy, weight, 0.0, -1, 10); }) ==
        "time is -1 s; it must be 0 or more");
  CHECK(complaint_of([&] { integrate_axis_evenly<Kutta>(heavy, weight, 0.0, 1, 0); }) ==
        "number of steps is 0; it must be 1 or more");
  auto orbit = eccentric_orbit<double>();
  orbit.start.velocity *= 2;
  CHECK(complaint_of([&] {
          carry_in_transformed_time<Verlet>(orbit.start, orbit.evaluate_forces, 1, 10);
        }).find("the orbit is open") != std::string::npos);
  CHECK(complaint_of([&] {
          carry_in_transformed_time<Verlet>(orbit.start, orbit.evaluate_forces, 1, 0);
        }) == "number of steps is 0; it must be 1 or more");
}

TEST_CASE("The rough logarithm and power are within 0.045, from 1e-37 to 3e38") {
  for (float value = 1e-37F; value < 3e38F; value *= 1.07F) {
    CHECK(std::abs(rough_log2(value) - std::log2(value)) <= 0.045F);
    const float exponent = std::log2(value);
    CHECK(std::abs(std::log2(rough_exp2(exponent)) - exponent) <= 0.045F);
  }
}
