// A hard case, live: any rung of the ladder, in either precision, with steps longer or shorter than
// the chapter's, and the chapter's own judge.
#include <optional>
#include <support/live.hpp>
#include <support/live_truth.hpp>
#include <support/trial.hpp>

using namespace tumble;

namespace {

using Column = std::vector<double>;

const int longest_watch = 3600;   // steps of the case's own length: a minute of A to D
const int steps_of_a_part = 500;  // a millisecond of the dearest rung
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

/// A flight as far as it has come, and what the figure shows of it.
template <class Real>
class Flight {
 public:
  Flight(std::size_t which, std::size_t rung, double factor)
      : which_(which),
        rung_(rung),
        factor_(factor),
        hard_(support::stretched(
            support::shortened(support::hard_cases<Real>()[which], longest_watch), factor)),
        top_(hard_.top),
        start_(in_double(top_)),
        exact_(start_) {}

  bool is_of(std::size_t which, std::size_t rung, double factor) const {
    return which == which_ && rung == rung_ && factor == factor_;
  }
  bool is_complete() const { return n_ == hard_.steps || motion_.diverged > 0; }

  void go_on() {
    for (int n = 0; n < steps_of_a_part && !is_complete(); ++n) step();
  }

  void write(support::Live& live) const {
    live.column("time", "s") = time_;
    live.column("energy", "") = energies_;
    live.column("momentum", "") = momenta_;
    live.column("time of the phase", "s") = until_;
    live.column("phase", "rad") = chords_;
    const support::Verdict verdict = support::judged(motion_, hard_.limits);
    live.column("fault", "").push_back(verdict.fault);
    live.column("worst", "").push_back(verdict.worst);
    live.column("error", "").push_back(verdict.error);
    live.column("diverged", "").push_back(verdict.diverged);
    live.column("steps", "").push_back(hard_.steps);
    live.column("step", "s").push_back(double(hard_.time_step));
    Column& allowed = live.column("allowed", "");
    for (const double limit : {hard_.limits.energy, hard_.limits.momentum, hard_.limits.angle})
      allowed.push_back(limit);
  }

 private:
  /// A point for each of the first steps, then for ever more of them: the largest error since the
  /// last point.
  void step() {
    const Real h = hard_.time_step;
    ++n_;
    turning_ladder<Real>[rung_].turn(top_, h);
    const Topd now = in_double(top_);
    const double ratio = kinetic_energy(now) / kinetic_energy(start_);
    const bool diverges = !(ratio < most_energy);
    const Vec3d L = angular_momentum_world(start_);
    worst_energy_ = std::max(worst_energy_, diverges ? most_energy : std::abs(ratio - 1));
    worst_momentum_ =
        std::max(worst_momentum_, (angular_momentum_world(now) - L).norm() / L.norm());
    if (n_ < next_ && n_ < hard_.steps && n_ != hard_.steps_to_angle && !diverges) return;
    next_ = n_ + 1 + n_ / 50;
    time_.push_back(n_ * double(h));
    energies_.push_back(worst_energy_);
    momenta_.push_back(worst_momentum_);
    if (diverges) {
      motion_.diverged = n_;
      return;
    }
    motion_.energy_error = std::max(motion_.energy_error, worst_energy_);
    motion_.momentum_error = std::max(motion_.momentum_error, worst_momentum_);
    worst_energy_ = worst_momentum_ = 0;
    const bool has_phase = hard_.limits.angle < support::any_error;
    if (!has_phase || n_ > hard_.steps_to_angle) return;
    support::turn_finely(exact_, (n_ - compared_) * double(h),
                         angular_velocity_body(start_).norm());
    compared_ = n_;
    until_.push_back(n_ * double(h));
    chords_.push_back(support::chord_between(exact_.orientation, now.orientation));
    motion_.angle = chords_.back();
  }

  std::size_t which_, rung_;
  double factor_;
  support::HardCase<Real> hard_;
  Top<Real> top_;
  Topd start_, exact_;
  support::Motion motion_;
  double worst_energy_ = 0, worst_momentum_ = 0;
  int n_ = 0, next_ = 1, compared_ = 0;
  Column time_, energies_, momenta_, until_, chords_;
};

template <class Real>
void fly(support::Live& live, std::size_t which, std::size_t rung, double factor) {
  static std::optional<Flight<Real>> kept;  // from one part of the work to the next
  if (!kept || !kept->is_of(which, rung, factor)) kept.emplace(which, rung, factor);
  kept->go_on();
  if (!kept->is_complete()) return live.go_on();
  kept->write(live);
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const auto which = static_cast<std::size_t>(live.choice("case", 3, 8));
  const auto rung = static_cast<std::size_t>(live.choice("rung", 18, 21));
  const bool single = live.choice("precision", 0, 2) == 1;
  const double factor = live.knob("step", "", 1, 0.125, 4);
  single ? fly<float>(live, which, rung, factor) : fly<double>(live, which, rung, factor);
}
