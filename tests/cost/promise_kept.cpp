// promise_kept ANSWER.json...: takes each answer of cost at its word. Runs the method, in the
// precision and with the steps that it names, and holds the run against an exact solution, in code
// that shares nothing with cost.
#include <course/scene_rules.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <tumble/exact/free_top.hpp>
#include <tumble/exact/kepler.hpp>
#include <tumble/ladder.hpp>
#include <tumble/scene/read_scene.hpp>

using namespace tumble;
using Json = nlohmann::json;

namespace {

[[noreturn]] void fail(const std::string& sentence) {
  std::fprintf(stderr, "error: %s\n", sentence.c_str());
  std::exit(EXIT_FAILURE);
}

template <class Real>
Top<long double> wide(const Top<Real>& top) {
  return {.orientation = normalized(Quaternion<long double>{
              top.orientation.real, top.orientation.imaginary.template cast<long double>()}),
          .angular_momentum_body = top.angular_momentum_body.template cast<long double>(),
          .inverse_moments = top.inverse_moments.template cast<long double>()};
}

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

/// Two scenes have exact solutions: a free top, and a planet around a star.
template <class Real>
double scene_error(const Json& question, const Json& promise) {
  const std::string name = question["scene"];
  const auto& words = turning_method_words<course::SceneRules>();
  const auto method = std::find(words.begin(), words.end(), promise["method"].get<std::string>());
  if (method == words.end()) fail("a world has no method " + promise["method"].dump());
  const long rate = promise["steps_per_second"], states = question["states_per_second"];
  Scene<Real> scene = read_scene_file<Real, OneByOne<Real>, course::SceneRules>(
      std::string(TUMBLE_SCENES) + "/" + name,
      {.step = steps_per_second(rate),
       .turning_method = static_cast<std::size_t>(method - words.begin())});
  const long steps = std::lround(question["seconds"].get<double>() * static_cast<double>(rate));
  const Bodies<Real>& bodies = scene.world.bodies();
  double worst = 0;
  if (name == "t_handle.json") {
    const exact::FreeTop<long double> truth(wide(bodies.tops[0]));
    for (long step = 1; step <= steps; ++step) {
      scene.world.step();
      if (step % (rate / states) != 0) continue;
      const auto right = truth.at(static_cast<long double>(step) / static_cast<long double>(rate));
      worst = std::max(worst,
                       double(angle_between(right.orientation, wide(bodies.tops[0]).orientation)));
    }
    return worst;
  }
  if (name == "orbit.json") {
    std::vector<exact::KeplerOrbit<long double>> orbits;
    for (const Particle<Real>& centre : bodies.centres)
      orbits.emplace_back(
          Particle<long double>{.position = centre.position.template cast<long double>(),
                                .velocity = centre.velocity.template cast<long double>()},
          static_cast<long double>(static_cast<Real>(3.986004418e14)));
    for (long step = 1; step <= steps; ++step) {
      scene.world.step();
      if (step % (rate / states) != 0) continue;
      for (std::size_t body = 0; body < orbits.size(); ++body) {
        const auto right =
            orbits[body].at(static_cast<long double>(step) / static_cast<long double>(rate));
        const Vec3<long double> place = bodies.centres[body].position.template cast<long double>();
        worst = std::max(worst, static_cast<double>((place - right.position).norm()));
      }
    }
    return worst;
  }
  fail("no exact solution of " + name);
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
