#include "options.hpp"

#include <cmath>
#include <cstdio>
#include <cxxopts.hpp>
#include <support/command_line.hpp>
#include <support/number_in.hpp>
#include <tumble/require.hpp>

namespace tumble::advise {
namespace {

constexpr const char* help = R"(advise SCENE --for SECONDS --angle RAD | --place METRES [OPTION...]
advise --inertia A,B,C --spin X,Y,Z --for SECONDS --angle RAD [OPTION...]

Measures on this machine which method, precision and time step is the cheapest that keeps
every orientation within --angle and every centre of mass within --place, at each state on
the way. It runs the winner again before it promises.

SCENE is the name of a scene in tools/scenes, such as t_handle, or the path of a
scene file.

  --inertia A,B,C     a free top instead: its principal moments, kg m^2
  --spin X,Y,Z        its angular velocity at the start about these axes, rad/s
  --for SECONDS       for how long; a whole number of states
  --angle RAD         the largest error of an orientation
  --place METRES      the largest error of a centre of mass; scenes only
  --rate N            how many states a second are wanted, 1 to 1000000; 60 if not given. No
                      step is longer
  --precision KIND    float, double or any (the default)
  --steps KIND        even: methods with steps of one length; own: methods that choose their
                      steps, which a free top has and a scene has not; any (the default):
                      both, and the exact solution, which takes none
  --longest-run S     a method is not tried with shorter steps once a run takes so many
                      seconds, 0.001 to 600; 1 if not given
  --json              answer in JSON, as answer.schema.json says
  --help              this text

The exit status is 0 if the promise is confirmed, 1 if none can be, and 2 if the command
line or the scene is wrong.
)";

const std::vector<std::string> options_with_value = {
    "inertia", "spin", "for", "angle", "place", "rate", "precision", "steps", "longest-run"};
const std::vector<std::string> options_without_value = {"json", "help"};

/// A number between `smallest` and `largest`, with `smallest` itself excluded where it is 0.
double between(const std::string& option, const std::string& text, const std::string& unit,
               double smallest, double largest) {
  const auto value = support::number_in(text);
  if (!value) throw UsageError("--" + option + " is " + text + "; it must be a number of " + unit);
  if (*value >= smallest && *value <= largest && *value > 0) return *value;
  throw UsageError("--" + option + " is " + text + " " + unit + "; it must be " +
                   (smallest > 0 ? "at least " + tumble::text_of(smallest) : "greater than 0") +
                   " and at most " + tumble::text_of(largest) + " " + unit);
}

std::array<double, 3> three_numbers(const std::string& option, const std::string& text,
                                    const std::string& unit) {
  std::array<double, 3> numbers = {};
  std::string_view rest = text;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t comma = n < 2 ? rest.find(',') : rest.size();
    const auto value = comma == std::string_view::npos
                           ? std::nullopt
                           : support::number_in(std::string(rest.substr(0, comma)));
    if (!value)
      throw UsageError("--" + option + " is " + text + "; it must be three numbers of " + unit +
                       " with commas between them, such as 1,2,3");
    numbers[n] = *value;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return numbers;
}

/// Three moments that some body has.
std::array<double, 3> moments_of(const std::string& text) {
  const auto I = three_numbers("inertia", text, "kg m^2");
  const auto refuse = [&](const std::string& rule) {
    throw UsageError("--inertia is " + text + " kg m^2; " + rule);
  };
  double sum = 0, largest = 0;
  for (const double moment : I) {
    if (!(moment > 0)) refuse("each moment must be greater than 0");
    if (!(moment >= 1e-300 && moment <= 1e300)) refuse("each must lie between 1e-300 and 1e300");
    sum += moment;
    largest = std::max(largest, moment);
  }
  // The numbers may be rounded to a few digits.
  if (largest > (sum - largest) * (1 + 1e-6))
    refuse("no body has these: the largest must not be more than the sum of the other two");
  return I;
}

Frames frames_of(const std::string& seconds, const std::string& rate) {
  Frames frames;
  const double states = between("rate", rate, "states a second", 1, 1e6);
  if (states != std::floor(states))
    throw UsageError("--rate is " + rate + "; it must be a whole number of states a second");
  frames.rate = static_cast<long>(states);
  const double count = between("for", seconds, "s", 0, 1e6) * states;
  frames.count = std::lround(count);
  if (std::abs(count - std::round(count)) > 1e-9 * count)
    throw UsageError("--for is " + seconds + " s; with " + rate +
                     " states a second it must be a whole number of states, not " +
                     tumble::text_of(count));
  if (frames.count > 10'000'000)
    throw UsageError("--for is " + seconds + " s; that makes " + std::to_string(frames.count) +
                     " states, and at most 10000000 are compared: lower --rate");
  return frames;
}

Precisions precisions_of(const std::string& kind) {
  if (kind == "any") return {};
  if (kind == "float") return {.single = true, .twice = false};
  if (kind == "double") return {.single = false, .twice = true};
  throw UsageError("--precision is " + kind + "; it must be float, double or any");
}

StepKinds step_kinds_of(const std::string& kind) {
  if (kind == "any") return {};
  if (kind == "even") return {.even = true, .own = false};
  if (kind == "own") return {.even = false, .own = true};
  throw UsageError("--steps is " + kind + "; it must be even, own or any");
}

Options read(const cxxopts::ParseResult& given) {
  const auto text = [&](const std::string& name, const std::string& otherwise = {}) {
    return given.count(name) > 0 ? given[name].as<std::string>() : otherwise;
  };
  const auto has = [&](const std::string& name) { return given.count(name) > 0; };
  Options options;
  const bool of_top = has("inertia") || has("spin");
  if (of_top && has("scene"))
    throw UsageError("either a scene or --inertia and --spin, not both: " + text("scene"));
  if (of_top) {
    if (!has("spin")) throw UsageError("--inertia needs --spin, the angular velocity");
    if (!has("inertia")) throw UsageError("--spin needs --inertia, the principal moments");
    options.top = {moments_of(text("inertia")), three_numbers("spin", text("spin"), "rad/s")};
    for (const double rate : options.top->spin)
      if (std::abs(rate) > 1e6)
        throw UsageError("--spin is " + text("spin") +
                         " rad/s; each must lie between -1e6 and 1e6");
  } else {
    if (!has("scene"))
      throw UsageError("which scene, or which --inertia and --spin? --help lists the options");
    options.scene = support::find_scene(text("scene"));
  }
  if (!has("for")) throw UsageError("for how long? --for SECONDS says it");
  options.frames = frames_of(text("for"), text("rate", "60"));
  if (has("place") && of_top) throw UsageError("--place is for scenes: a free top has no place");
  if (!has("angle") && !has("place"))
    throw UsageError(of_top ? "how accurate? --angle RAD says it"
                            : "how accurate? --angle RAD or --place METRES say it");
  if (has("angle")) options.tolerance.angle = between("angle", text("angle"), "rad", 0, 3);
  if (has("place")) options.tolerance.place = between("place", text("place"), "m", 0, 1e12);
  options.precisions = precisions_of(text("precision", "any"));
  options.kinds = step_kinds_of(text("steps", "any"));
  if (options.kinds.own && !options.kinds.even && !of_top)
    throw UsageError("--steps own is for a free top: the steps of a scene have one length");
  options.longest_run = between("longest-run", text("longest-run", "1"), "s", 0.001, 600);
  options.json = has("json") && given["json"].as<bool>();
  return options;
}

}  // namespace

std::optional<Options> read_options(int argument_count, char** arguments) {
  cxxopts::Options parser("advise");
  parser.allow_unrecognised_options();
  for (const std::string& name : options_with_value)
    parser.add_options()(name, "", cxxopts::value<std::string>());
  for (const std::string& name : options_without_value) parser.add_options()(name, "");
  parser.add_options()("scene", "", cxxopts::value<std::string>());
  parser.parse_positional({"scene"});
  try {
    const cxxopts::ParseResult given = parser.parse(argument_count, arguments);
    if (given.count("help") > 0 && given["help"].as<bool>()) {
      std::fputs(help, stdout);
      return std::nullopt;
    }
    if (!given.unmatched().empty())
      support::reject_word(given.unmatched()[0], {options_with_value, options_without_value});
    return read(given);
  } catch (const cxxopts::exceptions::exception& error) {
    throw UsageError(error.what());
  }
}

}  // namespace tumble::advise
