// promise_kept ANSWER.json...: takes each answer of advise at its word. Runs the method, in the
// precision and with the steps that it names, and holds the run against an exact solution, in code
// that shares nothing with advise.
#include <fstream>
#include <tumble/adaptive_ladder.hpp>
#include <tumble/exact/free_top.hpp>

#include "kept.hpp"

namespace {

/// The worst error of a state on the way.
template <class Real>
double free_top_error(const Json& question, const Json& promise) {
  // The closest pair of inverse moments goes first, in cyclic order of the sorted moments.
  std::array<int, 3> order = {0, 1, 2};
  const auto moment = [&](int axis) {
    return question["moments"][std::size_t(axis)].get<double>();
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return moment(a) < moment(b); });
  const bool odd = (order[0] + 1) % 3 != order[1];
  if (1 / moment(order[0]) - 1 / moment(order[1]) > 1 / moment(order[1]) - 1 / moment(order[2]))
    order = {order[1], order[2], order[0]};
  Top<Real> top;
  for (int axis = 0; axis < 3; ++axis) {
    const int from = order[std::size_t(axis)];
    top.inverse_moments[axis] = 1 / static_cast<Real>(moment(from));
    const Real spin = static_cast<Real>(question["spin"][std::size_t(from)].get<double>());
    // An odd order is a mirror: angular velocity is then the other way round.
    top.angular_momentum_body[axis] = (odd ? -spin : spin) / top.inverse_moments[axis];
  }
  const long states =
      std::lround(question["seconds"].get<double>() * question["states_per_second"].get<double>());
  const long rate = question["states_per_second"];
  const auto time_of = [&](long state) {
    return static_cast<long double>(state) / static_cast<long double>(rate);
  };
  const exact::FreeTop<long double> truth(wide(top));
  double worst = 0;
  const auto look = [&](const Top<Real>& at, long state) {
    const auto right = truth.at(time_of(state));
    worst = std::max(worst,
                     static_cast<double>(angle_between(right.orientation, wide(at).orientation)));
  };
  if (promise["method"] == "exact solution") {
    const exact::FreeTop<Real> solution(top);
    for (long state = 1; state <= states; ++state)
      look(solution.at(static_cast<Real>(time_of(state))), state);
    return worst;
  }
  for (const auto& rung : free_top_rungs<Real>) {
    if (rung.name != promise["method"].get<std::string>()) continue;
    const char* key = rung.given == Given::angle ? "angle_per_step" : "tolerance_per_second";
    const auto given = static_cast<Real>(promise[key].get<double>());
    StepCounts all;
    for (long state = 1; state <= states; ++state) {
      const StepCounts counts = rung.integrate(top, static_cast<Real>(time_of(1)), given);
      all.steps += counts.steps;
      all.rejected += counts.rejected;
      look(top, state);
    }
    const auto steps = promise["steps"].get<long>(),
               rejected = promise["rejected_steps"].get<long>();
    std::printf("%ld steps of the %ld that were expected, and %ld of %ld rejected\n", all.steps,
                steps, all.rejected, rejected);
    // The most of several runs that are alike.
    if (all.steps > steps || all.rejected > rejected) fail("more steps than were expected");
    if (2 * all.steps < steps) fail("far more steps were expected than are needed");
    return worst;
  }
  for (const auto& rung : turning_ladder<Real>) {
    if (rung.name != promise["method"].get<std::string>()) continue;
    const long steps = promise["steps_per_second"].get<long>() / rate;
    const Real h = static_cast<Real>(1.0L / promise["steps_per_second"].get<long double>());
    for (long state = 1; state <= states; ++state) {
      for (long n = 0; n < steps; ++n) rung.turn(top, h);
      look(top, state);
    }
    return worst;
  }
  fail("the ladder has no method " + promise["method"].dump());
}

void verify(const Json& answer, const char* which, double share) {
  const Json& promise = answer[which];
  if (promise.is_null()) fail(std::string(which) + " is null");
  const Json& question = answer["question"];
  const bool single = promise["precision"] == "float", scene = question.contains("scene");
  const double worst = scene    ? single ? scene_error<float>(question, promise)
                                         : scene_error<double>(question, promise)
                          : single ? free_top_error<float>(question, promise)
                                : free_top_error<double>(question, promise);
  const char* what = question["wanted_error"]["angle"].is_null() ? "place" : "angle";
  const double wanted = share * question["wanted_error"][what].get<double>(),
               expected = promise["expected_error"][what];
  std::printf("%s: %s errs in %s by %.3g; expected %.3g, promised %.3g\n", which,
              promise["method"].get<std::string>().c_str(), what, worst, expected, wanted);
  if (!(worst <= wanted)) fail("the promise is broken");
  // The worst of several runs that are alike is no less than this one's, and not absurdly more,
  // unless both are so small that roundings decide.
  if (worst <= wanted / 1000) return;
  if (!(worst <= 1.001 * expected)) fail("more error than was expected");
  if (!(expected <= 100 * worst)) fail("far more error was expected than there is");
}

}  // namespace

int main(int argument_count, char** arguments) {
  for (int n = 1; n < argument_count; ++n) {
    const Json answer = Json::parse(std::ifstream(arguments[n]));
    verify(answer, "cheapest", 1);
    if (!answer["ten_times_better"].is_null()) verify(answer, "ten_times_better", 0.1);
  }
}
