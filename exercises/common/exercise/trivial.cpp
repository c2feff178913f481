// Judge and worker in one process, for the audit: each check is run with every combination of
// trivial answers that it ever asks for, and those that it passes are printed.
#include <exercise/judge.hpp>
#include <exercise/trivial.hpp>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#include <map>

namespace tumble::exercise {

namespace {

constexpr int most_places = 8, most_checks = 16;

/// Where the search stands. It is shared with a child process that does the work, so that one that
/// crashes or never ends costs that one combination alone.
struct Search {
  struct Choice {
    int place, answer;
  };
  struct Combination {
    int length = 0;
    Choice choices[most_places];
  };
  bool is_done = false;
  int check = 0;
  Combination now;
  bool passes[most_checks] = {}, breaks[most_checks] = {};
  Combination first[most_checks];  ///< that passes, or breaks, a check
  long runs = 0;
};

enum class Outcome { passed, failed, needs_choice, broken };

std::vector<Check>& checks() {
  static std::vector<Check> all;
  return all;
}

std::map<std::string, double, std::less<>> parameters;
std::vector<Place> places;
std::initializer_list<Offer> offers;
Search* state = nullptr;
int needed = -1;  ///< the place for which nothing is chosen yet

Outcome outcome_of(void (*run)()) {
  needed = -1;
  try {
    run();
  } catch (const Verdict&) {
    return needed >= 0 ? Outcome::needs_choice : Outcome::failed;
  } catch (const Unreadable&) {
    return Outcome::failed;
  } catch (const std::exception&) {
    return Outcome::broken;
  }
  return Outcome::passed;
}

bool is_possible(const Search::Choice& choice) {
  const auto kind = trivial_answers[std::size_t(choice.answer)].kind;
  const Place& place = places[std::size_t(choice.place)];
  if (kind == TrivialAnswer::own_code) return place.has_own_code;
  return kind != TrivialAnswer::nothing || place.may_be_left;
}

/// Goes on to the next combination, or to the next check after the last.
void advance(Search& search, Outcome outcome) {
  Search::Combination& now = search.now;
  if (outcome == Outcome::passed || outcome == Outcome::broken) {
    (outcome == Outcome::passed ? search.passes : search.breaks)[search.check] = true;
    search.first[search.check] = now;
    now.length = 0;
  } else {
    if (outcome == Outcome::needs_choice) now.choices[now.length++] = {needed, -1};
    while (now.length > 0) {
      Search::Choice& last = now.choices[now.length - 1];
      do ++last.answer;
      while (last.answer < int(trivial_answers.size()) && !is_possible(last));
      if (last.answer < int(trivial_answers.size())) return;
      --now.length;
    }
  }
  ++search.check;
  search.is_done = search.check == int(checks().size());
}

/// A child's work: combination by combination, each with its own share of time.
[[noreturn]] void work(Search& search, int seconds) {
  const rlimit memory{1 << 30, 1 << 30};
  setrlimit(RLIMIT_AS, &memory);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  while (!search.is_done) {
    ++search.runs;
    const itimerval share{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_VIRTUAL, &share, nullptr);  // whose end ends the process
    advance(search, outcome_of(checks()[std::size_t(search.check)].in_double));
  }
  _exit(0);
}

std::string spoken(const Search::Combination& combination) {
  std::string text;
  for (int i = 0; i < combination.length; ++i) {
    const auto [place, answer] = combination.choices[i];
    text += (i > 0 ? "; " : "") + std::string(places[std::size_t(place)].name) + " answers with " +
            std::string(trivial_answers[std::size_t(answer)].name);
  }
  return text;
}

}  // namespace

Check::Check(const char* said, void (*run)(), void (*run_in_float)())
    : sentence(said), in_double(run), in_float(run_in_float) {
  checks().push_back(*this);
}

double parameter(std::string_view name) {
  return parameters.find(name)->second;
}

const TrivialAnswer& chosen_for(int place) {
  for (int i = 0; i < state->now.length; ++i)
    if (state->now.choices[i].place == place)
      return trivial_answers[std::size_t(state->now.choices[i].answer)];
  needed = place;
  throw NotChosen();
}

std::pair<std::string, std::string> reply_to(const Question& asked) {
  Words words(asked.line);
  const std::string line = replied(words, offers);
  if (needed >= 0) throw Verdict{"needs a choice", ""};
  const std::size_t space = std::min(line.find(' '), line.size());
  const std::string kind = line.substr(0, space);
  if (kind == "todo" || kind == "unreadable") throw Unreadable(line);
  return {kind, line.substr(std::min(space + 1, line.size()))};
}

/// search SECONDS [PARAMETER=VALUE...], the seconds being those that one combination may take.
int search(int argument_count, char** arguments, std::initializer_list<Place> its_places,
           std::initializer_list<Offer> its_offers) {
  places = its_places;
  offers = its_offers;
  if (argument_count < 2 || places.size() > most_places || checks().size() > most_checks) return 2;
  for (int i = 2; i < argument_count; ++i) {
    const std::string_view text = arguments[i];
    const std::size_t equals = std::min(text.find('='), text.size() - 1);
    parameters[std::string(text.substr(0, equals))] = std::strtod(&text[equals + 1], nullptr);
  }
  void* const shared =
      mmap(nullptr, sizeof(Search), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return 2;
  state = new (shared) Search;
  while (!state->is_done) {
    const pid_t child = fork();
    if (child < 0) return 2;
    if (child == 0) work(*state, std::atoi(arguments[1]));
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) advance(*state, Outcome::failed);
  }
  std::printf("{\"runs\": %ld, \"found\": [", state->runs);
  const char* separator = "";
  for (std::size_t i = 0; i < checks().size(); ++i) {
    if (!state->passes[i] && !state->breaks[i]) continue;
    std::printf("%s\n{\"check\": %zu, \"passes\": %s, \"answers\": \"%s\"}", separator, i,
                state->passes[i] ? "true" : "false", spoken(state->first[i]).c_str());
    separator = ",";
  }
  std::printf("]}\n");
  return 0;
}

}  // namespace tumble::exercise
