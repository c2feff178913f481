#include <answer.hpp>
#include <sstream>
#include <support/checks.hpp>

using namespace tumble::advise;

TEST_CASE("The answer in words says steps, prices and bodies in their units") {
  Answer answer;
  answer.asked.scene = "five.json";
  answer.asked.frames = {.count = 100, .rate = 10};
  answer.asked.tolerance.angle = 1e-6;
  answer.bodies = 5;
  answer.candidates.resize(3);
  answer.candidates[0].method = "quick", answer.candidates[0].precision = "double";
  answer.candidates[1].method = "slow", answer.candidates[1].precision = "float";
  Candidate& own = answer.candidates[2];
  own.method = "own", own.precision = "double", own.power = 2, own.coarsest = 0.1;
  const Errors errors{.angle = 2.5e-7};
  answer.verdict.winner = Found{&answer.candidates[0], 3, errors, 100};
  answer.verdict.others = {Found{&answer.candidates[1], 1, errors, 250}};
  answer.better = Found{&own, 4, {.angle = 5e-8, .steps = 250, .rejected = 1}, 300};
  answer.least = Found{&answer.candidates[1], 2, {.angle = 0.5}, 20};
  std::string words;
  for (const char letter : text_of(answer))  // wherever its lines are broken
    if (letter != '\n' && (letter != ' ' || words.empty() || words.back() != ' ')) words += letter;
  for (const char* said :
       {"five.json: 5 bodies, for 10 s, 10 states a second",
        "quick, in double, 3 steps a state: 0.0333333 s, 30 a second",
        "2.5e-07 rad, 4 times less than wanted", "100 ns for each simulated second",
        "10000000 such scenes in each frame of 1/60 s, on one thread: 50000000 bodies",
        "2.50 times the cost: slow, in float, 1 step a state: 0.1 s, 10 a second",
        "ten times better 3 times the cost: own, in double, tolerance 0.00625 rad a second: 250 "
        "steps in all and 1 repeated, 2.5 a state, 5e-08 rad",
        "nothing is; at 0.2 of the cost: slow, in float, 2 steps a state: 0.05 s, 20 a second, 0.5 "
        "rad"}) {
    CAPTURE(said);
    CAPTURE(words);
    CHECK(words.find(said) != std::string::npos);
  }
}

TEST_CASE("No line of the answer in words is longer than 92 letters") {
  Answer answer;
  answer.asked.top = FreeTopQuestion{};
  answer.refusal = "of";
  for (int n = 0; n < 50; ++n) answer.refusal += " a";  // 91 letters, and two more are too many
  std::istringstream words(text_of(answer));
  for (std::string line; std::getline(words, line);) CHECK(line.size() <= 92);
}
