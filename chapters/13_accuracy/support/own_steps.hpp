/// @file
/// Methods that choose their own steps as contestants: asked with a tolerance, or, in transformed
/// time, with about how many steps.
#pragma once

#include <support/contest.hpp>
#include <tumble/adaptive_ladder.hpp>
#include <tumble/transformed_time.hpp>

namespace tumble::support {

/// A state that is not a number.
template <class Real>
Top<Real> failed(Top<Real> top) {
  top.orientation.real = std::numeric_limits<Real>::quiet_NaN();
  return top;
}
template <class Real>
Particle<Real> failed(Particle<Real> particle) {
  particle.position.x() = std::numeric_limits<Real>::quiet_NaN();
  return particle;
}

/// One number as the tolerance of a body: of a particle so many m a second, and as many m/s, for
/// the problems' own times are seconds.
template <class Body, class Real>
ToleranceOf<Body> tolerance_of(Real tolerance) {
  if constexpr (std::is_same_v<ToleranceOf<Body>, Real>)
    return tolerance;
  else
    return {tolerance, tolerance};
}

/// A contestant that `integrate(body, tolerance)` takes through the whole problem. Where no step
/// meets the tolerance the answer is NaN.
template <class Body, class Forces, class Integrate>
Contestant<Body> own_steps(const std::string& name, const Problem<Body, Forces>& problem,
                           const Integrate& integrate) {
  using Real = typename ScalarOf<Body>::Type;
  return {name, "rung", true, [problem, integrate](double knob) {
            Body body = problem.start;
            try {
              integrate(body, problem.evaluate_forces, static_cast<Real>(problem.seconds),
                        static_cast<Real>(knob));
            } catch (const StepError&) {
              body = failed(body);
            }
            return body;
          }};
}

/// A free top by two rules in steps of one length, its L apart from the orientation.
template <class Real>
constexpr std::array<TurningRung<Real>, 2> even_momentum_ladder = {
    {{"L apart, Dormand-Prince 5", {.order = 5}, turn_by_momentum<DormandPrinceFifth, Real>},
     {"L apart, Dormand-Prince 8", {.order = 8}, turn_by_momentum<DormandPrinceEighth, Real>}}};

/// A free top by each rung that chooses its own steps.
template <class Real>
std::vector<Contestant<Top<Real>>> free_tops_by_own_steps(const FreeProblem<Real>& problem) {
  std::vector<Contestant<Top<Real>>> list;
  for (const FreeTopRung<Real>& rung : free_top_rungs<Real>)
    list.push_back(own_steps(
        std::string(rung.name), problem,
        [integrate = rung.integrate](Top<Real>& top, const NoTorque<Real>&, Real seconds,
                                     Real tolerance) { integrate(top, seconds, tolerance); }));
  return list;
}

/// A body under force or torque by one rung that chooses its own steps.
template <class Body, class Forces, class Real>
Contestant<Body> by_own_steps(const Problem<Body, Forces>& problem,
                              const AdaptiveRung<Body, Real, Forces>& rung) {
  return own_steps(std::string(rung.name), problem,
                   [integrate = rung.integrate](Body& body, const Forces& evaluate_forces,
                                                Real seconds, Real tolerance) {
                     integrate(body, evaluate_forces, Real(0), seconds,
                               tolerance_of<Body>(tolerance), {});
                   });
}

/// A body under force or torque by each pair; a symmetric top by its axis as well.
template <class Body, class Forces>
std::vector<Contestant<Body>> by_own_steps(const Problem<Body, Forces>& problem) {
  using Real = typename ScalarOf<Body>::Type;
  std::vector<Contestant<Body>> list;
  for (const auto& rung : adaptive_rungs<Body, Real, Forces>)
    list.push_back(by_own_steps(problem, rung));
  if constexpr (requires { problem.evaluate_forces.torque_on_axis(Vec3<Real>(), Real(0)); })
    for (const auto& rung : axis_rungs<Real, Forces>) list.push_back(by_own_steps(problem, rung));
  return list;
}

/// A symmetric top by its axis, by two rules in steps of one length.
template <class Real, class Forces>
std::vector<Contestant<Top<Real>>> axis_by_even_steps(const Problem<Top<Real>, Forces>& problem) {
  const auto by = [&]<class Rule>(const char* name, Rule) {
    return Contestant<Top<Real>>{name, "rung", false, [problem](double knob) {
                                   Top<Real> top = problem.start;
                                   integrate_axis_evenly<Rule>(
                                       top, problem.evaluate_forces, Real(0),
                                       static_cast<Real>(problem.seconds), static_cast<long>(knob));
                                   return top;
                                 }};
  };
  return {by("axis apart, Dormand-Prince 8", DormandPrinceEighth()),
          by("axis apart, Fehlberg 8", FehlbergEighth())};
}

/// A particle under a force of place and time alone, by the Nyström pair.
template <class Real, class Forces>
Contestant<Particle<Real>> nystrom_by_own_steps(const Problem<Particle<Real>, Forces>& problem) {
  return by_own_steps(problem, nystrom_rung<Real, Forces>);
}

/// An orbit in transformed time, by rows of several orders. The knob is about how many steps.
template <class Real, class Forces>
std::vector<Contestant<Particle<Real>>> in_transformed_time(
    const Problem<Particle<Real>, Forces>& problem) {
  const auto by = [&]<class Row>(const char* name, Row) {
    return Contestant<Particle<Real>>{name, "rung", false, [problem](double knob) {
                                        Particle<Real> particle = problem.start;
                                        carry_in_transformed_time<Row>(
                                            particle, problem.evaluate_forces,
                                            static_cast<Real>(problem.seconds),
                                            static_cast<long>(knob));
                                        return particle;
                                      }};
  };
  return {by("transformed time, Verlet", Verlet()),
          by("transformed time, Kahan-Li 6", KahanLiSixth()),
          by("transformed time, Kahan-Li 8", KahanLiEighth()),
          by("transformed time, Sofroniou-Spaletta", SofroniouSpaletta())};
}

}  // namespace tumble::support
