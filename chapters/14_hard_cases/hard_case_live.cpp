// A hard case, live: any rung of the ladder, in either precision, with steps longer or shorter than
// the chapter's, and the chapter's own judge.
#include <support/live.hpp>
#include <support/live_truth.hpp>
#include <support/trial.hpp>

using namespace tumble;

namespace {

using Column = std::vector<double>;

const int longest_watch = 3600;   // steps of the case's own length: a minute of A to D
const double most_energy = 1000;  // times what there was: as in `watched`, it has diverged

/// The same numbers in double, as the judge of the figure reads them: on every machine its
/// roundings are the same, which those of a long double are not.
template <class Real>
Topd in_double(const Top<Real>& top) {
  return {.orientation = normalized(Quaternion<double>{
              top.orientation.real, top.orientation.imaginary.template cast<double>()}),
          .angular_momentum_body = top.angular_momentum_body.template cast<double>(),
          .torque = Vec3d::Zero(),
          .inverse_moments = top.inverse_moments.template cast<double>()};
}

template <class Real>
void fly(support::Live& live, std::size_t which, std::size_t rung, double factor) {
  const support::HardCase<Real> hard = support::stretched(
      support::shortened(support::hard_cases<Real>()[which], longest_watch), factor);
  const Real h = hard.time_step;
  const bool has_phase = hard.limits.angle < support::any_error;

  Column &time = live.column("time", "s"), &energies = live.column("energy", ""),
         &momenta = live.column("momentum", ""), &until = live.column("time of the phase", "s"),
         &chords = live.column("phase", "rad");
  Top<Real> top = hard.top;
  const Topd start = in_double(top);
  Topd exact = start;
  const double energy = kinetic_energy(start), size = angular_momentum_world(start).norm();
  const double fastest = angular_velocity_body(start).norm();
  const Vec3d L = angular_momentum_world(start);
  support::Motion motion;
  // A point for each of the first steps, then for ever more of them: the largest error since the
  // last point.
  double worst_energy = 0, worst_momentum = 0;
  int next = 1, compared = 0;
  for (int n = 1; n <= hard.steps; ++n) {
    turning_ladder<Real>[rung].turn(top, h);
    const Topd now = in_double(top);
    const double ratio = kinetic_energy(now) / energy;
    const bool diverges = !(ratio < most_energy);
    worst_energy = std::max(worst_energy, diverges ? most_energy : std::abs(ratio - 1));
    worst_momentum = std::max(worst_momentum, (angular_momentum_world(now) - L).norm() / size);
    if (n < next && n < hard.steps && n != hard.steps_to_angle && !diverges) continue;
    next = n + 1 + n / 50;
    time.push_back(n * double(h));
    energies.push_back(worst_energy);
    momenta.push_back(worst_momentum);
    if (diverges) {
      motion.diverged = n;
      break;
    }
    motion.energy_error = std::max(motion.energy_error, worst_energy);
    motion.momentum_error = std::max(motion.momentum_error, worst_momentum);
    worst_energy = worst_momentum = 0;
    if (!has_phase || n > hard.steps_to_angle) continue;
    support::turn_finely(exact, (n - compared) * double(h), fastest);
    compared = n;
    until.push_back(n * double(h));
    chords.push_back(support::chord_between(exact.orientation, now.orientation));
    motion.angle = chords.back();
  }

  const support::Verdict verdict = support::judged(motion, hard.limits);
  live.column("fault", "").push_back(verdict.fault);
  live.column("worst", "").push_back(verdict.worst);
  live.column("error", "").push_back(verdict.error);
  live.column("diverged", "").push_back(verdict.diverged);
  live.column("steps", "").push_back(hard.steps);
  live.column("step", "s").push_back(double(h));
  Column& allowed = live.column("allowed", "");
  for (const double limit : {hard.limits.energy, hard.limits.momentum, hard.limits.angle})
    allowed.push_back(limit);
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const auto which = static_cast<std::size_t>(live.choice("case", 2, 7));
  const auto rung = static_cast<std::size_t>(live.choice("rung", 18, 21));
  const bool single = live.choice("precision", 0, 2) == 1;
  const double factor = live.knob("step", "", 1, 0.125, 4);
  single ? fly<float>(live, which, rung, factor) : fly<double>(live, which, rung, factor);
}
