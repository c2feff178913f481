// Runs the checks it is linked with once for each mutant that it is asked for, each time in a
// process of its own.
//
//   PROGRAM WANTED JOBS LONGEST
//
// prints "NUMBER<tab>END<tab>CHECK" for each mutant whose number is in the file WANTED, and
//
//   TUMBLE_MUTANT=17 PROGRAM
//
// runs all checks with mutant 17, as doctest does.
//
// At first each check runs alone without a mutant, which tells how long it takes and which mutants
// it reaches. A mutant then runs those that reach it, the quickest first, until one fails. The
// slowest are left out, as long as those that reach it take more than LONGEST seconds together. END
// is one of these:
//
// - killed: a check failed
// - crashed: the process ended by a signal
// - endless: a check computed 20 times as long as without the mutant and a second more, or took ten
//   times as long as that and 15 s more
// - survived: all checks that reach it held
// - unreached: no check reaches it
// - none: where it is reached its change would not compile
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "mutants.hpp"

namespace tumble_mutants {

namespace {

using Seen = std::vector<unsigned char>;

struct Check {
  doctest::detail::TestCase* test;
  double seconds = 0;
  Seen reached;
  bool holds = false;
};

/// What a child tells its parent.
struct Report {
  int check;       ///< the one that runs or has failed
  double seconds;  ///< of the processor
  unsigned char reached[most];
};

double processor_seconds() {
  rusage used;
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

void limit(double seconds) {
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>((seconds - double(timer.it_value.tv_sec)) * 1e6);
  setitimer(ITIMER_PROF, &timer, nullptr);
  alarm(static_cast<unsigned>(15 + 10 * seconds));
}

void be_quiet() {
  const int nowhere = open("/dev/null", O_RDWR);
  for (int stream = 0; stream < 3; ++stream) dup2(nowhere, stream);
  const rlimit memory = {4ull << 30, 4ull << 30}, none = {0, 0};
  setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CORE, &none);
}

/// Whether the check holds.
bool run(std::vector<Check>& checks, std::size_t index) {
  for (Check& check : checks) check.test->m_skip = true;
  checks[index].test->m_skip = false;
  doctest::Context context;
  context.setOption("abort-after", 1);
  context.setOption("no-breaks", true);
  return context.run() == 0;
}

struct Child {
  pid_t process;
  Report* report;
};

Report* shared_report() {
  return static_cast<Report*>(
      mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
}

std::string name_of(const Check& check) {
  return std::string(check.test->m_file.c_str())
             .substr(std::string(check.test->m_file.c_str()).rfind('/') + 1) +
         ": " + check.test->m_name;
}

/// Runs the checks of `order` with the mutant in a child, until one fails.
Child begin(std::vector<Check>& checks, int number, const std::vector<std::size_t>& order,
            Report* report) {
  report->check = -1;
  const pid_t process = fork();
  if (process != 0) return {process, report};
  be_quiet();
  chosen_number = number;
  for (const std::size_t index : order) {
    report->check = static_cast<int>(index);
    limit(1 + 20 * checks[index].seconds);
    if (!run(checks, index)) _exit(1);
  }
  _exit(0);
}

/// The same where static variables depend on the mutant: the program begins anew.
Child begin_anew(const std::vector<Check>& checks, const char* program, int number,
                 const std::vector<std::size_t>& order, Report* report) {
  report->check = -1;
  std::string words;
  for (const std::size_t index : order)
    words += std::to_string(index) + " " + std::to_string(checks[index].seconds) + " ";
  const pid_t process = fork();
  if (process != 0) return {process, report};
  be_quiet();
  setenv("TUMBLE_MUTANT", std::to_string(number).c_str(), 1);
  execl(program, program, words.c_str(), static_cast<char*>(nullptr));
  _exit(3);
}

/// What begin_anew() has begun: runs the checks whose indices and times `words` holds.
int run_in_order(std::vector<Check>& checks, const char* words) {
  std::istringstream order(words);
  double seconds = 0;
  for (std::size_t index = 0; order >> index >> seconds;) {
    limit(1 + 20 * seconds);
    if (!run(checks, index)) return 1;
  }
  return 0;
}

void survey(std::vector<Check>& checks, Seen& at_start) {
  at_start.assign(seen, seen + most);
  Report* report = shared_report();
  for (std::size_t index = 0; index < checks.size(); ++index) {
    const pid_t process = fork();
    if (process == 0) {
      be_quiet();
      std::memset(seen, 0, most);
      const double begun = processor_seconds();
      const bool holds = run(checks, index);
      report->seconds = processor_seconds() - begun;
      std::memcpy(report->reached, seen, most);
      _exit(holds ? 0 : 1);
    }
    int status = 0;
    waitpid(process, &status, 0);
    Check& check = checks[index];
    check.holds = status == 0;
    check.seconds = report->seconds;
    check.reached.assign(report->reached, report->reached + most);
    std::printf("0\t%s\t%.4f %s\n", check.holds ? "holds" : "fails", check.seconds,
                name_of(check).c_str());
  }
}

/// What became of a mutant, given how its process ended.
const char* end_of(int status) {
  if (WIFEXITED(status)) return WEXITSTATUS(status) == 0 ? "survived" : "killed";
  const int signal = WTERMSIG(status);
  return signal == SIGPROF || signal == SIGALRM ? "endless" : "crashed";
}

void print(int number, const char* end, const std::string& check) {
  std::printf("%d\t%s\t%s\n", number, end, check.c_str());
  std::fflush(stdout);
}

void try_all(std::vector<Check>& checks, const Seen& at_start, const std::vector<int>& wanted,
             std::size_t jobs, double longest, const char* program) {
  std::map<pid_t, std::pair<int, Report*>> running;
  std::vector<Report*> free_reports;
  for (std::size_t job = 0; job < jobs; ++job) free_reports.push_back(shared_report());
  const auto wait_for_one = [&] {
    int status = 0;
    const pid_t process = wait(&status);
    const auto [number, report] = running.at(process);
    running.erase(process);
    const char* end = end_of(status);
    const bool survived = std::strcmp(end, "survived") == 0;
    print(number, end,
          survived || report->check < 0 ? ""
                                        : name_of(checks[static_cast<std::size_t>(report->check)]));
    free_reports.push_back(report);
  };
  for (const int number : wanted) {
    const auto n = static_cast<std::size_t>(number);
    std::vector<std::size_t> order;
    bool has_none = at_start[n] == 2;
    for (std::size_t index = 0; index < checks.size(); ++index) {
      if (checks[index].reached[n] == 1 || at_start[n] == 1) order.push_back(index);
      has_none = has_none || checks[index].reached[n] == 2;
    }
    if (order.empty()) {
      print(number, has_none ? "none" : "unreached", "");
      continue;
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return checks[a].seconds < checks[b].seconds;
    });
    double seconds = 0;
    for (const std::size_t index : order) seconds += checks[index].seconds;
    for (; order.size() > 1 && seconds > longest; order.pop_back())
      seconds -= checks[order.back()].seconds;
    if (running.size() == jobs) wait_for_one();
    Report* report = free_reports.back();
    free_reports.pop_back();
    const Child child = at_start[n] == 1 ? begin_anew(checks, program, number, order, report)
                                         : begin(checks, number, order, report);
    running[child.process] = {number, child.report};
  }
  while (!running.empty()) wait_for_one();
}

}  // namespace
}  // namespace tumble_mutants

int main(int argc, char** argv) {
  using namespace tumble_mutants;
  const bool goes_on = argc == 2 && std::isdigit(argv[1][0]);
  if (argc != 4 && !goes_on) return doctest::Context(argc, argv).run();
  std::vector<Check> checks;
  for (const auto& test :
       doctest::detail::getRegisteredTests())  // what is changed is no part of their order
    checks.push_back({const_cast<doctest::detail::TestCase*>(&test), 0, {}, false});
  if (goes_on) return run_in_order(checks, argv[1]);
  Seen at_start;
  survey(checks, at_start);
  std::vector<int> wanted;
  std::ifstream file(argv[1]);
  for (int number = 0; file >> number;) wanted.push_back(number);
  std::fflush(stdout);
  try_all(checks, at_start, wanted, static_cast<std::size_t>(std::atoi(argv[2])),
          std::atof(argv[3]), argv[0]);
}
