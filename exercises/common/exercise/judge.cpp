// The judge's main: --list names the checks; otherwise one of them is run and its verdict printed.
#include <exercise/judge.hpp>

#include <unistd.h>
#include <csignal>
#include <cstring>
#include <map>
#include <random>

namespace tumble::exercise {

namespace {

std::vector<Check>& checks() {
  static std::vector<Check> all;
  return all;
}

FILE *questions = nullptr, *replies = nullptr;

/// What a function replied, and what it was asked when it first did.
using Asked = std::map<std::string, std::string>;
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

/// Whether a word is a quantity, which `put` writes in base 16; a count is written in base 10.
bool is_quantity(std::string_view word) {
  return word.find('x') != word.npos;
}

bool has_quantity(const std::string& line) {
  Words words(line);
  for (words.word(); !words.empty();)
    if (is_quantity(words.word())) return true;
  return false;
}

/// The question with each of its quantities larger by `part` to twice that, by chance and each by
/// another: so what depends on ratios alone changes too, and nobody can know what is asked. Smaller
/// for a negative part.
std::string nearby(const std::string& question, double part) {
  static std::mt19937_64 chance{std::random_device()()};
  std::uniform_real_distribution<double> how_much(1, 2);
  Words words(question);
  std::string changed(words.word());
  while (!words.empty()) {
    const std::string_view word = words.word();
    if (is_quantity(word))
      put(changed, Words(word).number() * (1 + part * how_much(chance)));
    else
      changed += ' ' + std::string(word);
  }
  return changed;
}

/// The reply to a question, or nothing where none comes that can be read.
std::string reply_or_nothing(const std::string& question) {
  try {
    const auto [kind, rest] = reply_to(question);
    return kind + " " + rest;
  } catch (const Verdict&) {
  } catch (const Unreadable&) {
  }
  return "";
}

/// Whether the function, which had one answer to all that was asked, has another one when it's
/// asked about something else; also where it does not answer, which says nothing against it here.
bool depends(const Asked& all) {
  const auto& [answer, question] = *all.begin();
  for (const int bits : {12, 8, 5}) {  // the last where a small change is rounded off in each step
    const std::string other = nearby(question, std::ldexp(1.0, -bits));
    if (other == question || reply_or_nothing(other) != answer) return true;
  }
  return false;
}

/// Whether the function has, somewhere near what it was asked, an answer that it has not given yet.
/// First very near, for what is no longer a unit quaternion may be refused; and on both sides, for
/// so may what is beyond a limit.
bool answers_anew(const Asked& all) {
  bool can_be_told = false;
  int tried = 0;
  for (const auto& [answer, question] : all) {
    if (!has_quantity(answer)) continue;
    if (++tried > 64) break;  // more would show nothing else
    for (const int bits : {22, 18, 14, 12, 8, 5})
      for (const double side : {1.0, -1.0}) {
        const std::string other = nearby(question, side * std::ldexp(1.0, -bits));
        if (other == question) continue;
        can_be_told = true;
        const std::string reply = reply_or_nothing(other);
        if (reply.starts_with("value ") && !all.contains(reply)) return true;
      }
  }
  return !can_be_told;
}

/// Who has read in a verdict what must come out may return that number, whatever is asked; and who
/// has a right answer to each question may look them up. So each function is asked once more, about
/// something else that nobody could know.
void require_dependence() {
  const auto of_this_check = asked;
  for (const auto& [function, all] : of_this_check) {
    require(all.size() > 1 || depends(all),
            function +
                " gives the same answer, to the bit, when it is asked about something else. What "
                "is asked must come into it");
    require(answers_anew(all),
            function +
                " answers what this check asks, and nothing that differs from it by a little. It "
                "must answer whatever it is asked, from what it is asked");
  }
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
  if (kind == "value") asked[question.substr(0, question.find(' '))].try_emplace(line, question);
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
