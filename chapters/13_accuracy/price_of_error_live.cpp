// What accuracy costs, live: every rung of the ladder with ever shorter steps, against the truth,
// the longest step with which it is near enough, and how steeply its error falls.
#include <limits>
#include <support/live.hpp>
#include <support/live_truth.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/ladder.hpp>

using namespace tumble;

namespace {

using Column = std::vector<double>;

constexpr int most_halvings = 24;     // of half a power of two each: 4096 steps
constexpr int steps_of_a_part = 500;  // a millisecond of the dearest rung
constexpr int start_at = 18;          // Dormand and Prince's rule of eighth order
static_assert(turning_ladder<double>[start_at].claims.order == 8);

/// What one rung errs by with so many steps.
struct Curve {
  Column steps, errors;  // rad
};

/// All rungs on one problem, as far as they have come.
struct Search {
  Topd start, truth;
  double seconds = 0;
  std::vector<Curve> curves;  ///< the last may lack runs
  Topd top;                   ///< of the run that is under way
  double steps = 1, done = 0;
  int halvings = 0, since_best = 0;
  double best = 4;  ///< no chord is longer than 2
};

Search searched(const support::TumblingProblem& problem) {
  Search search;
  search.seconds = static_cast<double>(problem.seconds_to_angle);
  search.top = search.truth = search.start = support::top_of<double>(problem);
  support::turn_finely(search.truth, search.seconds, angular_velocity_body(search.start).norm());
  search.curves.emplace_back();
  return search;
}

bool is_complete(const Search& search) {
  return search.curves.size() > std::size(turning_ladder<double>);
}

/// What a finished run errs by, and the next run: of the same rung, or of the next one where finer
/// steps make nothing better.
void take_run(Search& search) {
  // A rung that keeps no norm to rounding is judged by where it points.
  const double error =
      support::chord_between(search.truth.orientation, normalized(search.top.orientation));
  search.curves.back().steps.push_back(search.steps);
  search.curves.back().errors.push_back(error);
  search.since_best = error < 0.9 * search.best || !(error < 0.1) ? 0 : search.since_best + 1;
  if (error < search.best) search.best = error;
  if (++search.halvings > most_halvings || search.since_best == 6) {
    search.curves.emplace_back();
    search.halvings = search.since_best = 0;
    search.best = 4;
  }
  const int n = search.halvings;
  search.steps = std::floor(std::ldexp(n % 2 == 0 ? 1 : std::sqrt(2.0), n / 2) + 0.5);
  search.done = 0;
  search.top = search.start;
}

/// All rungs, a part at a time. Kept, so that who moves the tolerance alone waits for nothing.
const Search& continued(std::size_t which) {
  static std::array<std::vector<Search>, std::size(support::tumbling_problems)> known;
  if (known[which].empty()) known[which].push_back(searched(support::tumbling_problems[which]));
  Search& search = known[which].front();
  for (int n = 0; n < steps_of_a_part && !is_complete(search); ++n) {
    const TurningRung<double>& rung = turning_ladder<double>[search.curves.size() - 1];
    rung.turn(search.top, search.seconds / search.steps);
    if (++search.done == search.steps) take_run(search);
  }
  return search;
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

/// The slope of a curve with both axes logarithmic, by least squares over its eight finest runs
/// above the floor of rounding: the finer the steps, the straighter the curve. Too few: not a
/// number.
double slope_of(const Curve& curve) {
  constexpr double short_enough = 0.03, floor = 2e-11;  // rad; roundings have made 7e-12 at most
  constexpr std::size_t most_runs = 8, least_runs = 4;
  const Column& errors = curve.errors;
  std::size_t from = errors.size();
  while (from > 0 && errors[from - 1] <= short_enough) --from;
  std::size_t to = from;
  while (to < errors.size() && errors[to] > floor) ++to;
  if (to - from < least_runs) return std::numeric_limits<double>::quiet_NaN();
  from = std::max(from, to - std::min(to, most_runs));
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t n = from; n < to; ++n) {
    const double steps = support::binary_logarithm(curve.steps[n]);
    const double error = support::binary_logarithm(errors[n]);
    x += steps;
    y += error;
    xx += steps * steps;
    xy += steps * error;
  }
  const double count = static_cast<double>(to - from);
  return (count * xy - x * y) / (count * xx - x * x);
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const auto which =
      static_cast<std::size_t>(live.choice("problem", 0, std::size(tumbling_problems)));
  // Which rung is lit, the exact solution after the last, what one has for a simulated second and
  // whether all rungs are shown change only how it is drawn: the page knows the prices.
  live.choice("method", start_at, std::size(turning_ladder<double>) + 1);
  live.choice("budget", 0, 2);
  const double wanted = live.knob("wanted", "rad", 1e-4, 1e-10, 0.1);
  live.knob("spent", "ns", 1000, 10, 1e6);
  live.choice("rungs", 0, 2);
  const Search& search = continued(which);
  if (!is_complete(search)) return live.go_on();
  live.column("seconds", "s").push_back(search.seconds);
  Column &needed = live.column("needed", ""), &reached = live.column("reached", "rad"),
         &order = live.column("order", ""), &slope = live.column("slope", "");
  for (std::size_t rung = 0; rung < std::size(turning_ladder<double>); ++rung) {
    const Curve& curve = search.curves[rung];
    const std::size_t n = first_within(curve, wanted);
    const bool is_met = n < curve.steps.size();
    needed.push_back(is_met ? curve.steps[n] : 0);
    reached.push_back(is_met ? curve.errors[n] : 0);
    order.push_back(turning_ladder<double>[rung].claims.order);
    slope.push_back(slope_of(curve));
    live.column("steps " + std::to_string(rung), "") = curve.steps;
    live.column("error " + std::to_string(rung), "rad") = curve.errors;
  }
}
