#include <answer.hpp>
#include <support/checks.hpp>

using namespace tumble::advise;

namespace {

/// Of five bodies in a scene: one promise of each kind.
Answer answer_about_a_scene() {
  Answer answer;
  answer.asked.scene = "folder/five.json";
  answer.asked.frames = {.count = 100, .rate = 10};
  answer.asked.tolerance = {.angle = 1e-6, .place = 1e-3};
  answer.bodies = 5;
  answer.reference = "a reference";
  answer.uncertainty = {.angle = 1.25e-9, .place = 2e-6};
  answer.candidates.resize(3);
  answer.candidates[0] = {.method = "quick", .precision = "double", .scheme = "verlet"};
  answer.candidates[1] = {.method = "slow", .precision = "float"};
  answer.candidates[2] = {.method = "own", .precision = "double", .power = 2, .coarsest = 0.1};
  const Found quick{&answer.candidates[0], 3, {.angle = 2.5e-7, .place = 2e-5}, 100},
      slow{&answer.candidates[1], 1, {.angle = 5e-7, .place = 1e-4}, 250};
  answer.verdict.winner = quick;
  answer.verdict.others = {slow, quick, slow, quick};
  answer.better = Found{
      &answer.candidates[2], 4, {.angle = 5e-8, .place = 1e-5, .steps = 250, .rejected = 1}, 300};
  answer.least = Found{&answer.candidates[1], 2, {.angle = 0.5, .place = 0.25}, 20};
  return answer;
}

/// Of a free top: nothing is ten times better, but something cheaper.
Answer answer_about_a_top() {
  Answer answer;
  answer.asked.top = FreeTopQuestion{{1, 2, 2.5}, {0.5, -3, 1e-3}};
  answer.asked.frames = {.count = 2, .rate = 1};
  answer.asked.tolerance.angle = 0.25;
  answer.reference = "a reference";
  answer.uncertainty = {.angle = 1e-18};
  answer.candidates.resize(2);
  answer.candidates[0] = {.method = "exact", .precision = "double", .takes_steps = false};
  answer.candidates[1] = {
      .method = "own", .precision = "float", .power = 1, .is_given_angle = true, .coarsest = 1};
  answer.verdict.winner =
      Found{&answer.candidates[0], 1, {.angle = 0.125, .energy = 1e-16, .momentum = 2e-16}, 1.5e9};
  answer.worse = Found{&answer.candidates[1], 4, {.angle = 2, .steps = 1}, 1};
  return answer;
}

/// What is refused, for a reason that is a letter too long for a line.
Answer refused_answer() {
  Answer answer = answer_about_a_scene();
  answer.bodies = 1;
  answer.uncertainty = failed_run;
  answer.verdict.nearest = std::exchange(answer.verdict.winner, {});
  answer.refusal = "of";
  for (int n = 0; n < 36; ++n) answer.refusal += " a";
  return answer;
}

}  // namespace

TEST_CASE("The answer in words says steps, prices and bodies in their units") {
  CHECK(text_of(answer_about_a_scene()) ==
        R"(The scene five.json: 5 bodies, for 10 s, 10 states a second
wanted             errors of at most 1e-06 rad and 0.001 m, all the way
tried              every method that a scene can name, and each scheme that may pay,
                   whatever the file names
cheapest           quick, scheme verlet, in double, 3 steps a state: 0.0333333 s, 30 a
                   second
expected error     2.5e-07 rad and 2e-05 m, 4 times less than wanted
confirmed          against a reference, sure to 1.3e-09 rad and 2e-06 m
costs              100 ns for each simulated second
that makes         10000000 such scenes in each frame of 1/60 s, on one thread: 50000000
                   bodies
ten times better   3 times the cost: own, in double, tolerance 0.00625 rad a second: 250
                   steps in all and 1 repeated, 2.5 a state, 5e-08 rad and 1e-05 m
ten times cheaper  nothing is; at 0.2 of the cost: slow, in float, 2 steps a state: 0.05 s,
                   20 a second, 0.5 rad and 0.25 m
would do too       2.50 times the cost: slow, in float, 1 step a state: 0.1 s, 10 a second
                   the same cost: quick, scheme verlet, in double, 3 steps a state:
                   0.0333333 s, 30 a second
                   2.50 times the cost: slow, in float, 1 step a state: 0.1 s, 10 a second
)");
  CHECK(
      text_of(answer_about_a_top()) ==
      R"(A free top: moments 1, 2, 2.5 kg m^2, spin 0.5, -3, 0.001 rad/s, for 2 s, 1 state a second
wanted             errors of at most 0.25 rad, all the way
cheapest           exact, in double, asked once a state
expected error     0.12 rad, 2 times less than wanted
                   relative errors: energy 1e-16, angular momentum 2e-16
confirmed          against a reference, sure to 1e-18 rad
                   with this top, and with three that are like it
costs              1500000000 ns for each simulated second
that makes         not even one of these fits in a frame of 1/60 s
ten times better   can't be confirmed
ten times cheaper  2 rad: own, in float, angle 0.25 rad a step: 1 step in all, 0.5 a state
)");
  Answer good = answer_about_a_scene();
  good.better = good.verdict.winner;
  good.verdict.winner->errors = {.angle = 1e-12, .place = 6.76e-7};
  CHECK(text_of(good).find(", 1500 times less than wanted\n") != std::string::npos);
  CHECK(text_of(good).find("\nten times better   the cheapest is that already\n") !=
        std::string::npos);
  Answer one = answer_about_a_top();
  one.verdict.winner->nanoseconds = 6e8;
  one.verdict.winner->errors = {};
  CHECK(text_of(one).find("expected error     0 rad\n") != std::string::npos);
  CHECK(
      text_of(one).find(
          "\nthat makes         1 such top in each frame of 1/60 s, on one thread, one by one\n") !=
      std::string::npos);
}

TEST_CASE("A refusal in words says why, and no line of it is longer than 92 letters") {
  CHECK(text_of(refused_answer()) == R"(The scene five.json: 1 body, for 10 s, 10 states a second
wanted             errors of at most 1e-06 rad and 0.001 m, all the way
tried              every method that a scene can name, and each scheme that may pay,
                   whatever the file names
refused            of a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a a
                   a
reference          a reference, sure to inf rad and inf m
nearest            quick, scheme verlet, in double, 3 steps a state: 0.0333333 s, 30 a
                   second: 2.5e-07 rad and 2e-05 m
)");
}
