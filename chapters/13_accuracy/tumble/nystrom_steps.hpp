/// @file
/// A particle that chooses its own steps by a Nyström pair, where force depends on time and place.
#pragma once

#include <tumble/embedded_steps.hpp>
#include <tumble/nystrom_pairs.hpp>

namespace tumble {

/// The rows of a Nyström pair.
template <class Pair>
struct RowOfVelocities {
  static constexpr auto& row = Pair::rule.velocities;
};
template <class Pair>
struct RowOfErrorsOfPlaces {
  static constexpr auto& row = Pair::rule.errors_of_places;
};
template <class Pair>
struct RowOfErrorsOfVelocities {
  static constexpr auto& row = Pair::rule.errors_of_velocities;
};

/// Steps of a particle by a Nyström pair, for integrate_adaptively(). Velocities take no part in a
/// stage, so each stage weighs three numbers instead of six, and eight of them reach the order for
/// which a rule that does not tell positions from velocities needs at least eleven (Butcher 1985).
template <class Pair, class Forces, class Real>
class NystromSteps {
 public:
  static constexpr int power = Pair::power - 1;  ///< of the error per second

  NystromSteps(const Particle<Real>& particle, const Forces& evaluate_forces, Real time,
               const ParticleTolerance<Real>& tolerance)
      : evaluate_forces_(evaluate_forces), there_(particle), time_(time), tolerance_(tolerance) {
    const Vec3<Real>&x = particle.position, &v = particle.velocity;
    place_ = {x[0], x[1], x[2]};
    velocity_ = {v[0], v[1], v[2]};
    rates_[0] = acceleration_at(place_, 0);
  }

  /// Makes a step of h seconds. @return the square of its error, with 1 allowed
  //! [attempt_nystrom]
  [[gnu::flatten]] Real attempt(Real h) {
    step_ = h;
    for_each_index<stage_count - 1>([&](auto before) {
      constexpr StageNumber<before + 1> i;
      const Real ahead = static_cast<Real>(Pair::rule.nodes[i]) * h;
      end_place_ = place_by<RowOfStage<Pair, i>>(ahead);  // the last one is the end of the step
      rates_[i] = acceleration_at(end_place_, ahead);
    });
    end_velocity_ = combine<RowOfVelocities<Pair>>(velocity_, h, rates_);
    return error();
  }
  //! [attempt_nystrom]

  /// What was attempted last counts as a step.
  void accept() {
    time_ += step_;
    place_ = end_place_;
    velocity_ = end_velocity_;
    rates_[0] = rates_[stage_count - 1];
  }

  /// See first_step_of().
  [[gnu::flatten]] Real first_step(Real seconds) {
    const Real ahead = seconds / 10000;
    Three there = place_;
    for (std::size_t n = 0; n < 3; ++n) there[n] += ahead * velocity_[n];
    Three change = acceleration_at(there, ahead), gain = rates_[0];
    for (std::size_t n = 0; n < 3; ++n) change[n] -= rates_[0][n], gain[n] *= ahead;
    const auto size = [&](const Three& a, const Three& b) {
      return std::sqrt(square_of_error(joined(a, b), joined(place_, velocity_),
                                       joined(place_, velocity_), tolerance_, Real(1)));
    };
    return first_step_of<Real>(size(velocity_, rates_[0]), size(gain, change) / ahead, power,
                               seconds);
  }

  /// The particle where the last step that was accepted ends.
  Particle<Real> body() const {
    Particle<Real> body = there_;
    set_state(body, joined(place_, velocity_));
    return body;
  }

 private:
  using Three = StateVector<Real, 3>;
  static constexpr std::size_t stage_count = Pair::rule.nodes.size();

  static StateVector<Real, 6> joined(const Three& a, const Three& b) {
    return {a[0], a[1], a[2], b[0], b[1], b[2]};
  }

  [[gnu::always_inline]] Three acceleration_at(const Three& place, Real ahead) {
    there_.position = {place[0], place[1], place[2]};
    evaluate_forces_(there_, time_ + ahead);
    const Vec3<Real>& F = there_.force;
    const Real i = there_.inverse_mass;
    return {i * F[0], i * F[1], i * F[2]};
  }

  template <class Row>
  [[gnu::always_inline]] Three place_by(Real ahead) const {
    return each<Real, 3>([&](auto n) {
      return place_[n] + (ahead * velocity_[n] + step_ * step_ * weighed_number<Row, n>(rates_));
    });
  }

  [[gnu::always_inline]] Real error() const {
    const StateVector<Real, 6> off = each<Real, 6>([&](auto n) {
      if constexpr (n < 3)
        return step_ * step_ * weighed_number<RowOfErrorsOfPlaces<Pair>, n>(rates_);
      else
        return step_ * weighed_number<RowOfErrorsOfVelocities<Pair>, n - 3>(rates_);
    });
    return square_of_error(off, joined(place_, velocity_), joined(end_place_, end_velocity_),
                           tolerance_, step_);
  }

  const Forces& evaluate_forces_;
  Particle<Real> there_;  // to ask for its force
  Real time_, step_ = 0;
  ParticleTolerance<Real> tolerance_;
  Three place_ = {}, velocity_ = {}, end_place_ = {}, end_velocity_ = {};
  std::array<Three, stage_count> rates_ = {};
};

/// Like integrate(), by a Nyström pair such as DormandPrinceNystrom86, where the force depends on
/// time and place alone.
/// @throws std::invalid_argument as integrate().
/// @throws StepError if no step meets the tolerance.
template <class Pair, class Forces, class Real>
StepCounts integrate_by_nystrom(Particle<Real>& particle, const Forces& evaluate_forces, Real time,
                                Same<Real> seconds, ParticleTolerance<Same<Real>> tolerance,
                                const Stops<Same<Real>>& stops = {}) {
  require_tolerance<Real>(seconds, tolerance);
  return in_legs(particle, evaluate_forces, time, seconds, stops,
                 [&](auto& there, const auto& within, Real begin, Real length) {
                   NystromSteps<Pair, std::decay_t<decltype(within)>, Real> steps(there, within,
                                                                                  begin, tolerance);
                   return integrate_leg(there, steps, length, stops.longest);
                 });
}

}  // namespace tumble
