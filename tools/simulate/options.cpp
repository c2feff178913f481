#include "options.hpp"

#include <cmath>
#include <cstdio>
#define CXXOPTS_NO_REGEX  // to compile std::regex takes longer than all else here
#include <cxxopts.hpp>
#include <limits>
#include <support/command_line.hpp>
#include <support/number_in.hpp>
#include <support/scene_rules.hpp>
#include <thread>
#include <tumble/scene/scene_error.hpp>
#include <tumble/step_clock.hpp>

namespace tumble::simulate {
namespace {

constexpr const char* help = R"(simulate SCENE [OPTION...]

SCENE is the name of a scene in tools/scenes, such as t_handle, or the path of a
scene file.

  --plan              print the plan and do nothing else
  --check-plan        step the scene by its plan, and beside it without: every effect visits
                      every body, and all are kicked, drift and turn; say where the two
                      part, if they do
  --dt SECONDS        another time step, 1e-6 to 3600; rounded to whole nanoseconds
  --until SECONDS     simulate this long instead of the scene's duration, to the nearest
                      whole number of steps
  --method METHOD     turn by another rule of chapter 8, or by a rung of chapter 13; for a
                      METHOD that does not exist the answer lists those that do
  --scheme SCHEME     step all bodies by semi_implicit_euler, verlet or suzuki: order 1, 2
                      or 4 where nothing limits it; --plan says what does
  --precision KIND    double (the default) or float
  --seed N            draw other random bodies: N, 0 to 2^53, is added to each seed of the
                      file
  --threads N         let N threads share the work, 1 to 1024; by default one for each
                      processor. No bit depends on it

  --csv FILE          write the trajectory: time, body, position and velocity of the centre
                      of mass, orientation of the model, angular velocity; world axes
  --jsonl FILE        the same, an object of JSON in each line
  --plot FILE.svg     draw paths and energies
  --view FILE.html    write a page that replays the motion
  --follow BODY       let the camera of that page go with the body of this name, and draw the
                      body's path
  --live FILE.html    write a page that holds the engine and the scene, so that one can
                      change it, run it and replay it, and do nothing else
  --books FILE.json   write the books of energy and momentum with all digits
  --every N           record only every N-th step (and the first and last moment)

  --no-ledger         do not keep the books of energy and momentum
  --bill              measure what each effect costs
  --help              this text

Ctrl-C ends the simulation; the files then hold what was computed. A lost terminal, SIGTERM,
and the end of the program that reads the output do the same. The exit status is 0 if
everything was simulated, 1 if a step could not be taken, 2 if the command line or the scene
is wrong, 3 if a file could not be written, 4 if memory or threads did not suffice, and 128
plus the number of the signal that ended it: 130 after Ctrl-C.
)";

const std::vector<std::string> options_with_value = {
    "dt",   "until", "method", "scheme",  "precision", "csv",  "jsonl", "plot",
    "view", "live",  "every",  "threads", "books",     "seed", "follow"};
const std::vector<std::string> switches = {"plan", "check-plan", "no-ledger", "bill", "help"};

double seconds(const std::string& option, const std::string& text) {
  const std::optional<double> value = support::number_in(text);
  if (!value) throw UsageError("--" + option + " is " + text + "; it must be a number of seconds");
  return *value;
}

std::int64_t whole_number(const std::string& option, const std::string& text,
                          const std::string& rule, std::int64_t least, std::int64_t most) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
    throw UsageError("--" + option + " is " + text + "; it must be " + rule);
  return value;
}

StepLength rounded_step(const std::string& text, std::string& said) {
  const double given = seconds("dt", text);
  if (!(given >= 1e-6 && given <= 3600))
    throw UsageError("--dt is " + text + " s; it must lie between 1e-6 and 3600 s");
  const auto nanoseconds = static_cast<std::int64_t>(std::llround(given * 1e9));
  said = "a time step of " + text + " s is taken as " + std::to_string(nanoseconds) + " ns";
  return step_of_nanoseconds(nanoseconds);
}

/// Whether two paths lead to one file, through whatever links; a file that is not there yet is
/// known by its path.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
  namespace fs = std::filesystem;
  std::error_code unknown;  // whoever opens the file says what is wrong with it
  if (fs::equivalent(one, other, unknown)) return true;
  const fs::path place = fs::weakly_canonical(fs::absolute(one, unknown), unknown);
  return !place.empty() && place == fs::weakly_canonical(fs::absolute(other, unknown), unknown);
}

/// Throws if an output would go where the scene is, or where another one goes.
void require_different_files(const Options& options) {
  const std::vector<std::pair<std::string, std::filesystem::path>> outputs = {
      {"--csv", options.csv},   {"--jsonl", options.json_lines}, {"--plot", options.plot},
      {"--view", options.view}, {"--live", options.live},        {"--books", options.books}};
  for (auto one = outputs.begin(); one != outputs.end(); ++one) {
    const auto& [option, path] = *one;
    if (path.empty()) continue;
    if (is_same_file(path, options.scene))
      throw UsageError(option + " is " + path.string() +
                       "; that is the scene itself, and it would be overwritten");
    for (auto other = outputs.begin(); other != one; ++other)
      if (!other->second.empty() && is_same_file(path, other->second))
        throw UsageError(option + " is " + path.string() + "; that is where " + other->first +
                         " goes, and each needs a file of its own");
  }
}

/// Of a switch: --plan, --plan=true and --plan=false can be written.
bool is_on(const cxxopts::ParseResult& given, const std::string& name) {
  return given.count(name) > 0 && given[name].as<bool>();
}

Options read(const cxxopts::ParseResult& given) {
  const auto text = [&](const std::string& name) { return given[name].as<std::string>(); };
  Options options;
  if (given.count("scene") == 0) throw UsageError("which scene? --help lists the options");
  options.scene = support::find_scene(text("scene"));
  options.only_plan = is_on(given, "plan");
  options.check_plan = is_on(given, "check-plan");
  options.ledger = !is_on(given, "no-ledger");
  options.bill = is_on(given, "bill");
  if (!options.ledger && given.count("books"))
    throw UsageError("--books writes the books that --no-ledger does not keep");
  if (given.count("dt")) options.changes.step = rounded_step(text("dt"), options.said);
  if (given.count("until")) {
    options.until = seconds("until", text("until"));
    if (!(*options.until > 0 && *options.until <= longest_duration))
      throw UsageError("--until is " + text("until") +
                       " s; it must be greater than 0 and at most 1e9 s");
  }
  const auto place_in = [&](const auto& words, const std::string& option) {
    const auto found = std::find(words.begin(), words.end(), text(option));
    if (found == words.end()) {
      std::string all;
      for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
      throw UsageError("no " + option + " is called " + text(option) +
                       did_you_mean(text(option), {words.begin(), words.end()}) + "\nThe " +
                       option + "s are: " + all);
    }
    return static_cast<std::size_t>(found - words.begin());
  };
  if (given.count("method"))
    options.changes.turning_method =
        place_in(turning_method_words<support::SceneRules>(), "method");
  if (given.count("scheme")) options.changes.scheme = Scheme(place_in(scheme_words(), "scheme"));
  if (given.count("precision")) {
    options.is_float = text("precision") == "float";
    if (!options.is_float && text("precision") != "double")
      throw UsageError("--precision is " + text("precision") + "; it must be float or double");
  }
  if (given.count("every"))
    options.every = whole_number("every", text("every"), "a whole number of steps, 1 or more", 1,
                                 std::numeric_limits<std::int64_t>::max());
  if (given.count("seed"))
    options.changes.seed = static_cast<std::uint64_t>(whole_number(
        "seed", text("seed"), "a whole number from 0 to 2^53", 0, std::int64_t{1} << 53));
  const auto processors = static_cast<std::int64_t>(std::thread::hardware_concurrency());
  options.threads = static_cast<int>(
      given.count("threads") ? whole_number("threads", text("threads"), "from 1 to 1024", 1, 1024)
                             : std::clamp<std::int64_t>(processors, 1, 1024));
  const auto path = [&](const std::string& name) {
    if (given.count(name) > 0 && text(name).empty())
      throw UsageError("--" + name + " needs the name of a file");
    return given.count(name) > 0 ? std::filesystem::path(text(name)) : std::filesystem::path();
  };
  options.csv = path("csv");
  options.json_lines = path("jsonl");
  options.plot = path("plot");
  options.view = path("view");
  options.live = path("live");
  options.books = path("books");
  if (given.count("follow")) {
    options.follow = text("follow");
    if (options.follow.empty()) throw UsageError("--follow needs the name of a body");
    if (options.view.empty() && options.live.empty())
      throw UsageError("--follow is for the page that --view writes");
  }
  if (options.check_plan)
    for (const char* output : {"csv", "jsonl", "plot", "view", "live", "books"})
      if (given.count(output) > 0)
        throw UsageError("--check-plan compares two runs and writes no files; --" +
                         std::string(output) + " can't go with it");
  if (!options.live.empty())
    for (const cxxopts::KeyValue& other : given.arguments())
      if (other.key() != "live" && other.key() != "scene")
        throw UsageError(
            "--live writes a page of the scene as its file has it and runs nothing; --" +
            other.key() + " can't go with it");
  require_different_files(options);
  return options;
}

}  // namespace

std::optional<Options> read_options(int argument_count, char** arguments) {
  cxxopts::Options parser("simulate");
  parser.allow_unrecognised_options();
  for (const std::string& name : options_with_value)
    parser.add_options()(name, "", cxxopts::value<std::string>());
  for (const std::string& name : switches) parser.add_options()(name, "");
  parser.add_options()("scene", "", cxxopts::value<std::string>());
  parser.parse_positional({"scene"});
  try {
    const cxxopts::ParseResult given = parser.parse(argument_count, arguments);
    if (is_on(given, "help")) {
      std::fputs(help, stdout);
      return std::nullopt;
    }
    if (!given.unmatched().empty())
      support::reject_word(given.unmatched()[0], {options_with_value, switches});
    return read(given);
  } catch (const cxxopts::exceptions::exception& error) {
    throw UsageError(error.what());
  }
}

}  // namespace tumble::simulate
