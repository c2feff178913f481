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

/// A worker at the other end of two pipes.
struct Worker {
  FILE *questions = nullptr, *replies = nullptr;

  std::string reply_to(const std::string& question) const {
    std::fprintf(questions, "%s\n", question.c_str());
    std::fflush(questions);
    constexpr std::size_t longest = 1 << 16;  // ten times what the longest right reply takes
    std::string line;
    for (int letter; (letter = std::fgetc(replies)) != EOF;) {
      if (letter == '\n') return line;
      line += static_cast<char>(letter);
      if (line.size() > longest) throw Unreadable("it is longer than 64 KB");
    }
    throw Verdict{"silent", ""};
  }
};

Worker student, reference;
std::uint64_t seed = 0;
double rounding = 0;

/// By function what it was asked and answered: not all of it, but a sample.
struct Sample {
  Asked kept;
  std::size_t seen = 0;
};
std::map<std::string, Sample, std::less<>> asked;

std::map<std::string, double, std::less<>> parameters;

/// JSON's own letters for those that would end a text.
std::string quoted(std::string_view text) {
  std::string json = "\"";
  for (const char letter : one_line(text)) {
    if (letter == '"' || letter == '\\') json += '\\';
    json += letter;
  }
  return json + '"';
}

void keep(const Question& question, const std::string& reply) {
  constexpr std::size_t most = 24;
  if (may_be_off() >= 1) return;
  static Varied chance(seed);
  Sample& sample = asked[question.line.substr(0, question.line.find(' '))];
  ++sample.seen;
  if (sample.kept.size() < most)
    sample.kept.emplace_back(question, reply);
  else if (const std::size_t place = chance.below(sample.seen); place < most)
    sample.kept[place] = {question, reply};
}

/// Where a solution is at hand, each function that the check has asked must agree with it.
void require_agreement() {
  if (reference.questions == nullptr) return;
  Varied varied(seed);
  const auto of_reference = [](const std::string& line) {
    try {
      return reference.reply_to(line);
    } catch (const Verdict&) {
      throw std::runtime_error("the solution gave no answer to " + line);
    }
  };
  const auto of_student = [](const std::string& line) { return student.reply_to(line); };
  for (const auto& [function, sample] : asked) {
    const auto found =
        agreement(sample.kept, of_reference, of_student, varied, may_be_off(), rounding);
    require(found.is_enough(),
            function + " is right where this check asks, and hardly anywhere else: of " +
                std::to_string(found.cases) +
                " questions that differ from its own in one number, " +
                std::to_string(found.right) +
                " got a right answer. It must answer whatever it is asked, from what it is asked");
  }
}

Verdict verdict_of(void (*run)()) {
  try {
    run();
    require_agreement();
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

std::pair<std::string, std::string> reply_to(const Question& question) {
  const std::string line = student.reply_to(question.line);
  const std::size_t space = std::min(line.find(' '), line.size());
  std::string kind = line.substr(0, space), rest = line.substr(std::min(space + 1, line.size()));
  if (kind == "todo") throw Verdict{"todo", rest};
  if (kind == "unreadable") throw Unreadable(rest);
  if (kind != "value" && kind != "refused" && kind != "threw") throw Unreadable("no reply at all");
  if (kind == "value") keep(question, line);
  return {kind, rest};
}

double parameter(std::string_view name) {
  const auto found = parameters.find(name);
  if (found == parameters.end())
    throw std::logic_error("exercise.json has no parameter called " + std::string(name));
  return found->second;
}

}  // namespace tumble::exercise

// judge --list, or: judge NUMBER-OF-CHECK PRECISION SEED QUESTIONS REPLIES QUESTIONS REPLIES
// [PARAMETER=VALUE...]; questions and replies are file descriptors, of the student's worker and of
// the reference, which are -1 where there is no solution.
int main(int argument_count, char** arguments) {
  using namespace tumble::exercise;
  if (argument_count == 2 && std::strcmp(arguments[1], "--list") == 0) return list();
  if (argument_count < 8) return 2;
  std::signal(SIGPIPE, SIG_IGN);
  const auto number = static_cast<std::size_t>(std::atoi(arguments[1]));
  seed = std::strtoull(arguments[3], nullptr, 10);
  student = {fdopen(std::atoi(arguments[4]), "w"), fdopen(std::atoi(arguments[5]), "r")};
  reference = {fdopen(std::atoi(arguments[6]), "w"), fdopen(std::atoi(arguments[7]), "r")};
  if (student.questions == nullptr || student.replies == nullptr || number >= checks().size())
    return 2;
  for (int i = 8; i < argument_count; ++i) {
    const char* const equals = std::strchr(arguments[i], '=');
    if (equals == nullptr) return 2;
    parameters[std::string(arguments[i], static_cast<std::size_t>(equals - arguments[i]))] =
        std::strtod(equals + 1, nullptr);
  }
  const Check& check = checks()[number];
  const bool in_float = std::strcmp(arguments[2], "float") == 0;
  rounding = double(in_float ? unit_roundoff<float> : unit_roundoff<double>);
  const Verdict verdict = verdict_of(in_float ? check.in_float : check.in_double);
  std::printf("{\"status\": %s, \"message\": %s}\n", quoted(verdict.status).c_str(),
              quoted(verdict.message).c_str());
  return 0;
}
