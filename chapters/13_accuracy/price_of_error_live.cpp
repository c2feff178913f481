// The error that one allows, live: every rung of the ladder with ever shorter steps, against the
// truth, and the longest step with which it is near enough.
#include <course/live.hpp>
#include <course/live_truth.hpp>
#include <course/tumbling_problems.hpp>
#include <tumble/ladder.hpp>

using namespace tumble;

namespace {

using Column = std::vector<double>;

constexpr int most_halvings = 24;  // of half a power of two each: 4096 steps

/// What one rung errs by with so many steps.
struct Curve {
  Column steps, errors;  // rad
};

double error_with(const TurningRung<double>& rung, const Topd& start, const Topd& truth,
                  double seconds, double steps) {
  Topd top = start;
  for (double n = 0; n < steps; ++n) rung.turn(top, seconds / steps);
  // A rung that keeps no norm to rounding is judged by where it points.
  return course::chord_between(truth.orientation, normalized(top.orientation));
}

/// All rungs, on one problem. Kept, so that who moves the tolerance alone waits for nothing.
const std::vector<Curve>& curves_of(std::size_t which) {
  static std::array<std::vector<Curve>, std::size(course::tumbling_problems)> known;
  std::vector<Curve>& curves = known[which];
  if (!curves.empty()) return curves;
  const course::TumblingProblem& problem = course::tumbling_problems[which];
  const double seconds = static_cast<double>(problem.seconds_to_angle);
  const Topd start = course::top_of<double>(problem);
  Topd truth = start;
  course::turn_finely(truth, seconds, angular_velocity_body(start).norm());
  for (const TurningRung<double>& rung : turning_ladder<double>) {
    Curve curve;
    double best = 4;  // no chord is longer than 2
    for (int n = 0, since_best = 0; n <= most_halvings && since_best < 6; ++n) {
      const double steps = std::floor(std::ldexp(n % 2 == 0 ? 1 : std::sqrt(2.0), n / 2) + 0.5);
      const double error = error_with(rung, start, truth, seconds, steps);
      curve.steps.push_back(steps);
      curve.errors.push_back(error);
      since_best = error < 0.9 * best || !(error < 0.1) ? 0 : since_best + 1;
      if (error < best) best = error;
    }
    curves.push_back(curve);
  }
  return curves;
}

/// The first of a curve's runs that is near enough, and the next finer one as well, since an error
/// can be small by luck; none: as many as there are.
std::size_t first_within(const Curve& curve, double wanted) {
  for (std::size_t n = 0; n < curve.errors.size(); ++n)
    if (curve.errors[n] <= wanted &&
        (n + 1 == curve.errors.size() || curve.errors[n + 1] <= wanted))
      return n;
  return curve.errors.size();
}

}  // namespace

void tumble::course::run_live(Live& live) {
  const auto which =
      static_cast<std::size_t>(live.choice("problem", 0, std::size(tumbling_problems)));
  const double wanted = live.knob("wanted", "rad", 1e-4, 1e-10, 0.1);
  const std::vector<Curve>& curves = curves_of(which);
  live.column("seconds", "s")
      .push_back(static_cast<double>(tumbling_problems[which].seconds_to_angle));
  Column &needed = live.column("needed", ""), &reached = live.column("reached", "rad");
  for (std::size_t rung = 0; rung < curves.size(); ++rung) {
    const Curve& curve = curves[rung];
    const std::size_t n = first_within(curve, wanted);
    const bool is_met = n < curve.steps.size();
    needed.push_back(is_met ? curve.steps[n] : 0);
    reached.push_back(is_met ? curve.errors[n] : 0);
    live.column("steps " + std::to_string(rung), "") = curve.steps;
    live.column("error " + std::to_string(rung), "rad") = curve.errors;
  }
}
