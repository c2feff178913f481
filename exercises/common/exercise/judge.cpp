// The judge's main: --list names the checks; otherwise one of them is run and its verdict printed.
#include <exercise/judge.hpp>

#include <unistd.h>
#include <csignal>
#include <cstring>
#include <map>

namespace tumble::exercise {

namespace {

std::vector<Check>& checks() {
  static std::vector<Check> all;
  return all;
}

FILE *questions = nullptr, *replies = nullptr;

/// What a function was asked first, what it replied, and whether it has replied anything else
/// since.
struct Asked {
  std::string question, reply;
  bool varies = false;
};
std::map<std::string, Asked, std::less<>> asked;

std::map<std::string, double, std::less<>> parameters;

/// The next line of the worker, or nothing if it has ended; a line without end is no reply.
std::string line_from_worker() {
  constexpr std::size_t longest = 1 << 20;
  std::string line;
  for (int letter; (letter = std::fgetc(replies)) != EOF && line.size() < longest;) {
    if (letter == '\n') return line;
    line += static_cast<char>(letter);
  }
  throw Verdict{"silent", ""};
}

/// JSON's own letters for those that would end a text.
std::string quoted(std::string_view text) {
  std::string json = "\"";
  for (const char letter : one_line(text)) {
    if (letter == '"' || letter == '\\') json += '\\';
    json += letter;
  }
  return json + '"';
}

/// The question with each of its numbers a little larger, by up to 7/16384, none of them by as much
/// as its neighbours: so what depends on ratios alone changes too. A count below 2340 stays as it
/// is, for what follows the point is cut off.
std::string nearby(const std::string& question) {
  Words words(question);
  std::string changed(words.word());
  for (int n = 0; !words.empty(); ++n) put(changed, words.number() * (1 + (n % 7 + 1) / 16384.0));
  return changed;
}

/// Whether the function answers otherwise when it's asked about something else; also where it does
/// not answer, which says nothing against it.
bool depends(const Asked& first) {
  const std::string other = nearby(first.question);
  if (first.varies || other == first.question) return true;
  try {
    const auto [kind, rest] = reply_to(other);
    return kind + " " + rest != first.reply;
  } catch (const Verdict&) {
  } catch (const Unreadable&) {
  }
  return true;
}

/// Who has read in a verdict what must come out may return that number, whatever is asked. So where
/// all that a check has asked of a function has one answer, it's asked once more.
void require_dependence() {
  const auto of_this_check = asked;
  for (const auto& [function, first] : of_this_check)
    require(depends(first), function +
                                " gives the same answer, to the bit, when it is asked about "
                                "something else. What is asked must come into it");
}

Verdict verdict_of(void (*run)()) {
  try {
    run();
    require_dependence();
  } catch (const Verdict& verdict) {
    return verdict;
  } catch (const Unreadable& error) {
    return {"failed", std::string("the reply to a question could not be read: ") + error.what()};
  }
  return {"passed", ""};
}

int list() {
  for (std::size_t i = 0; i < checks().size(); ++i)
    std::printf("%s%s", i == 0 ? "[" : ",\n", quoted(checks()[i].sentence).c_str());
  std::printf("]\n");
  return 0;
}

}  // namespace

Check::Check(const char* sentence_, void (*in_double_)(), void (*in_float_)())
    : sentence(sentence_), in_double(in_double_), in_float(in_float_) {
  checks().push_back(*this);
}

std::pair<std::string, std::string> reply_to(const std::string& question) {
  std::fprintf(questions, "%s\n", question.c_str());
  std::fflush(questions);
  const std::string line = line_from_worker();
  const std::size_t space = std::min(line.find(' '), line.size());
  std::string kind = line.substr(0, space), rest = line.substr(std::min(space + 1, line.size()));
  if (kind == "todo") throw Verdict{"todo", rest};
  if (kind == "unreadable") throw Unreadable(rest);
  if (kind != "value" && kind != "refused" && kind != "threw") throw Unreadable("no reply at all");
  if (kind == "value") {
    const auto found =
        asked.try_emplace(question.substr(0, question.find(' ')), Asked{question, line});
    found.first->second.varies |= found.first->second.reply != line;
  }
  return {kind, rest};
}

double parameter(std::string_view name) {
  const auto found = parameters.find(name);
  if (found == parameters.end())
    throw std::logic_error("exercise.json has no parameter called " + std::string(name));
  return found->second;
}

}  // namespace tumble::exercise

// judge --list, or: judge NUMBER-OF-CHECK PRECISION QUESTIONS REPLIES [PARAMETER=VALUE...];
// questions and replies are file descriptors.
int main(int argument_count, char** arguments) {
  using namespace tumble::exercise;
  if (argument_count == 2 && std::strcmp(arguments[1], "--list") == 0) return list();
  if (argument_count < 5) return 2;
  std::signal(SIGPIPE, SIG_IGN);
  const auto number = static_cast<std::size_t>(std::atoi(arguments[1]));
  questions = fdopen(std::atoi(arguments[3]), "w");
  replies = fdopen(std::atoi(arguments[4]), "r");
  if (questions == nullptr || replies == nullptr || number >= checks().size()) return 2;
  for (int i = 5; i < argument_count; ++i) {
    const char* const equals = std::strchr(arguments[i], '=');
    if (equals == nullptr) return 2;
    parameters[std::string(arguments[i], static_cast<std::size_t>(equals - arguments[i]))] =
        std::strtod(equals + 1, nullptr);
  }
  const Check& check = checks()[number];
  const bool in_float = std::strcmp(arguments[2], "float") == 0;
  const Verdict verdict = verdict_of(in_float ? check.in_float : check.in_double);
  std::printf("{\"status\": %s, \"message\": %s}\n", quoted(verdict.status).c_str(),
              quoted(verdict.message).c_str());
  return 0;
}
