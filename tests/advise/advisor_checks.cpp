#include <advisor.hpp>
#include <support/checks.hpp>

using namespace tumble::advise;

namespace {

constexpr Frames frames{.count = 10, .rate = 10};  // a second
constexpr double longest_run = 1;

/// A method whose error is `first` with one step a frame and falls by its order down to `floor`; a
/// step costs `price` ns.
Candidate method(const char* name, int order, double first, double price, double floor = 0) {
  return {.method = name,
          .precision = "double",
          .order = order,
          .errors =
              [=](long steps, int) {
                return Errors{
                    .angle = std::max(first / std::pow(static_cast<double>(steps), order), floor)};
              },
          .nanoseconds = [=](long steps,
                             int) { return price * static_cast<double>(steps * frames.count); }};
}

Verdict asked(const std::vector<Candidate>& candidates, double angle) {
  return Advisor(candidates, frames, longest_run).cheapest({.angle = angle});
}

}  // namespace

TEST_CASE(
    "The advisor takes the cheap method for a coarse tolerance and the dear one for a fine one") {
  const std::vector<Candidate> list = {method("first order", 1, 1, 10),
                                       method("fourth order", 4, 0.1, 100)};
  const Verdict coarse = asked(list, 1), fine = asked(list, 1e-8);
  REQUIRE(coarse.winner.has_value());
  REQUIRE(fine.winner.has_value());
  CHECK(coarse.winner->candidate->method == "first order");
  CHECK(fine.winner->candidate->method == "fourth order");
}

TEST_CASE("The advisor's steps are as few as will do, and what it expects is what it found") {
  const std::vector<Candidate> list = {method("second order", 2, 1, 10)};
  for (const double tolerance : {0.3, 1e-2, 1e-5, 3e-7}) {
    const Verdict verdict = asked(list, tolerance);
    REQUIRE(verdict.winner.has_value());
    const auto steps = static_cast<double>(verdict.winner->fineness);
    CHECK(verdict.winner->errors.angle == 1 / (steps * steps));
    CHECK(verdict.winner->errors.angle <= tolerance / 2);
    // Half of the tolerance is aimed at; a twentieth of the steps, and one, may be too many.
    const double fewer = steps / 1.06 - 1;
    CHECK(1 / (fewer * fewer) >= tolerance / 2);
    CHECK(verdict.winner->nanoseconds == doctest::Approx(10 * 10 * steps));
  }
}

TEST_CASE(
    "Where rounding stops every method above the tolerance, the advisor refuses and says how near "
    "it "
    "came") {
  const std::vector<Candidate> list = {method("float", 4, 0.1, 10, 1e-5),
                                       method("double", 4, 0.1, 20, 1e-13)};
  CHECK(asked(list, 1e-4).winner->candidate->method == "float");
  CHECK(asked(list, 1e-7).winner->candidate->method == "double");
  const Verdict verdict = asked(list, 1e-17);
  CHECK(!verdict.winner.has_value());
  REQUIRE(verdict.nearest.has_value());
  CHECK(verdict.nearest->candidate->method == "double");
  CHECK(verdict.nearest->errors.angle == 1e-13);
  CHECK(list[1].errors(verdict.nearest->fineness, 0).angle == 1e-13);
}

TEST_CASE(
    "A promise holds for the questions like the one asked, or the advisor takes shorter steps") {
  for (const int worst : {1, 2})
    for (const double tolerance : {0.3, 1e-4}) {
      Candidate uneven = method("second order", 2, 1, 10);
      uneven.trials = 3;
      uneven.errors = [=](long steps, int trial) {
        return Errors{.angle = (trial == worst ? 3 : 1) / static_cast<double>(steps * steps)};
      };
      const std::vector<Candidate> list = {uneven};
      const Verdict verdict = asked(list, tolerance);
      REQUIRE(verdict.winner.has_value());
      const auto steps = static_cast<double>(verdict.winner->fineness);
      CHECK(verdict.winner->errors.angle == 3 / (steps * steps));
      CHECK(verdict.winner->errors.angle <= tolerance);
      // Each attempt takes a fifth more steps, and one, than the one before, which did not do.
      const double before = (steps - 1) / 1.2;
      CHECK(3 / (before * before) > tolerance);
    }
}

TEST_CASE("A method that fails when it is run again is passed over, however cheap") {
  Candidate lucky = method("lucky", 2, 1, 1);
  lucky.trials = 2;
  lucky.errors = [](long steps, int trial) {
    return trial == 0 ? Errors{.angle = 1 / static_cast<double>(steps * steps)} : failed_run;
  };
  const std::vector<Candidate> list = {lucky, method("sound", 2, 1, 3)};
  const Verdict verdict = asked(list, 1e-4);
  REQUIRE(verdict.winner.has_value());
  CHECK(verdict.winner->candidate->method == "sound");
  for (const bool takes_steps : {true, false}) {
    lucky.takes_steps = takes_steps;
    const std::vector<Candidate> lucky_alone = {lucky};
    CHECK(!asked(lucky_alone, takes_steps ? 1e-4 : 2).winner.has_value());
  }
}

TEST_CASE("A run that ends in no number, or lasts too long, or never converges, is no answer") {
  Candidate diverging = method("diverging", 4, 1, 1);
  diverging.errors = [](long, int) { return Errors{.angle = NAN}; };
  Candidate constant = method("constant", 4, 0.5, 1);
  constant.errors = [](long, int) { return Errors{.angle = 0.5}; };
  // A first order needs 2e8 steps a frame for 1e-8, of 100 ns: minutes.
  const std::vector<Candidate> list = {diverging, constant, method("slow", 1, 1, 100)};
  CHECK(!asked(list, 1e-8).winner.has_value());
  CHECK(asked(list, 1e-2).winner->candidate->method == "slow");
}

TEST_CASE("On a method that gains nothing from shorter steps no more time is spent") {
  int runs = 0;
  Candidate constant = method("constant", 4, 0.5, 1e-6);
  constant.errors = [&runs](long, int) {
    ++runs;
    return Errors{.angle = 0.5};
  };
  const std::vector<Candidate> list = {constant};
  CHECK(!asked(list, 1e-8).winner.has_value());
  CHECK(runs <= 6);  // one, and four that gain nothing
}

namespace {

/// A method as above that notes the dearest run of it, ns.
Candidate watched(const char* name, int order, double price, double& dearest) {
  Candidate made = method(name, order, 1, price);
  made.nanoseconds = [=, &dearest, time = made.nanoseconds](long steps, int repetitions) {
    dearest = std::max(dearest, time(steps, repetitions));
    return time(steps, repetitions);
  };
  return made;
}

}  // namespace

TEST_CASE("Methods are tried from the highest order down") {
  const std::vector<Candidate> list = {method("first", 1, 1, 10), method("third", 3, 1, 10),
                                       method("second", 2, 1, 10)};
  std::string told;
  const auto tell = [&](const Candidate& candidate, std::size_t n, std::size_t of) {
    told += candidate.method + " " + std::to_string(n) + "/" + std::to_string(of) + ", ";
  };
  (void)Advisor(list, frames, longest_run, tell).cheapest({.angle = 1});
  CHECK(told == "third 1/3, second 2/3, first 3/3, ");
}

TEST_CASE("No more time is spent on a method than on four times the cheapest so far, twice") {
  double dearest = 0;
  // 1/8^5, 0.1/7^4 and 1/142^2 are below the half of 1e-4: 80,000 ns, 700 ns and 2130 ns; the last
  // needs 20,000 steps.
  const std::vector<Candidate> list = {method("tried first", 5, 1, 1000),
                                       method("cheap", 4, 0.1, 10), method("dear", 2, 1, 1.5),
                                       watched("dearest", 1, 1, dearest)};
  const Verdict verdict = asked(list, 1e-4);
  REQUIRE(verdict.winner.has_value());
  CHECK(verdict.winner->candidate->method == "cheap");
  REQUIRE(verdict.others.size() == 1);
  CHECK(verdict.others[0].candidate->method == "dear");
  CHECK(verdict.others[0].nanoseconds > 3 * verdict.winner->nanoseconds);
  CHECK(dearest > 4 * verdict.winner->nanoseconds);
  CHECK(dearest <= 2 * 4 * verdict.winner->nanoseconds);
}

TEST_CASE("The longest run is meant as a whole, for however many seconds it simulates") {
  double dearest = 0;
  const std::vector<Candidate> list = {watched("slow", 1, 100, dearest)};
  const Frames ten_seconds{.count = frames.count, .rate = 1};
  CHECK(!Advisor(list, ten_seconds, longest_run).cheapest({.angle = 1e-9}).winner);
  CHECK(dearest > 1e9 * longest_run);
  CHECK(dearest <= 2 * 1e9 * longest_run);
}

TEST_CASE("What diverges with long steps may do with short ones") {
  Candidate stiff = method("stiff", 2, 1, 10);
  stiff.errors = [](long steps, int) {
    return steps < 64 ? failed_run : Errors{.angle = 1 / static_cast<double>(steps * steps)};
  };
  const std::vector<Candidate> list = {stiff};
  REQUIRE(asked(list, 1e-2).winner.has_value());
  CHECK(asked(list, 1e-2).winner->fineness >= 64);
}

TEST_CASE("A solution that takes no steps is asked once a frame, or not at all") {
  Candidate exact = method("exact", 0, 1e-15, 500);
  exact.takes_steps = false;
  const std::vector<Candidate> list = {method("second order", 2, 1, 10), exact};
  CHECK(asked(list, 1e-2).winner->candidate->method == "second order");
  const Verdict fine = asked(list, 1e-10);
  REQUIRE(fine.winner.has_value());
  CHECK(fine.winner->candidate->method == "exact");
  CHECK(fine.winner->fineness == 1);
  CHECK(!asked(list, 1e-15).winner.has_value());
}

TEST_CASE("A tolerance for places counts places, and one for both counts both") {
  Candidate body = method("body", 2, 1, 10);
  body.errors = [](long steps, int) {
    const auto n = static_cast<double>(steps);
    return Errors{.angle = 1 / (n * n), .place = 100 / (n * n)};
  };
  const std::vector<Candidate> list = {body};
  const Advisor advisor(list, frames, longest_run);
  const auto steps = [&](const Tolerance& tolerance) {
    return advisor.cheapest(tolerance).winner->fineness;
  };
  const long both = steps({.angle = 1e-2, .place = 1e-2});
  CHECK(both == steps({.place = 1e-2}));
  CHECK(both > 5 * steps({.angle = 1e-2}));
}

namespace {

/// A method that chooses its steps, at least one in a frame: ever smaller tolerances have the same
/// ones as long as a frame meets them. The error is that of the rule, in steps of that length.
Candidate choosing(const char* name, int power, double first, double price) {
  Candidate made = method(name, power + 1, first, price);
  made.power = power;
  made.coarsest = 0.1;
  made.finest = 1000;
  const auto steps_at = [made_of = made, first, power](long fineness) {
    // What is estimated of the error per second is `first` times the step to that power.
    const double wanted = std::pow(first / made_of.given(fineness), 1.0 / power);
    return std::max(1L, static_cast<long>(std::ceil(wanted)));
  };
  made.errors = [=](long fineness, int) {
    const long steps = steps_at(fineness);
    return Errors{.angle = first / std::pow(static_cast<double>(steps), power + 1),
                  .steps = steps * frames.count,
                  .rejected = steps - 1};
  };
  made.nanoseconds = [=](long fineness, int) {
    return price * static_cast<double>(steps_at(fineness) * frames.count);
  };
  return made;
}

}  // namespace

TEST_CASE(
    "Of a method that chooses its steps the advisor finds the tolerance, and says the steps") {
  for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
    CAPTURE(tolerance);
    const std::vector<Candidate> list = {choosing("own", 4, 1, 10)};
    const Verdict verdict = asked(list, tolerance);
    REQUIRE(verdict.winner.has_value());
    const Found& found = *verdict.winner;
    CHECK(found.errors.angle <= tolerance / 2);
    CHECK(found.errors.steps > 0);
    CHECK(found.errors.rejected == found.errors.steps / frames.count - 1);
    // Coarser by a twentieth, and one, it would not do, or it is at its coarsest.
    const long coarser = found.fineness - found.fineness / 16 - 1;
    if (coarser >= 1) CHECK(list[0].errors(coarser, 0).angle > tolerance / 2);
  }
}

TEST_CASE("That smaller tolerances call for the same steps does not end the search") {
  // One step a frame meets 0.1 divided by 2^4, 4^4, 8^4, 16^4 and more.
  const std::vector<Candidate> list = {choosing("own", 4, 1e-7, 10)};
  REQUIRE(list[0].given(2) == 0.1 / 16);
  REQUIRE(list[0].errors(1, 0).angle == list[0].errors(16, 0).angle);
  const Verdict verdict = asked(list, 1e-9);
  REQUIRE(verdict.winner.has_value());
  CHECK(verdict.winner->fineness > 16);
  CHECK(verdict.winner->errors.angle <= 1e-9 / 2);
  // But there is an end to it.
  std::vector<Candidate> hopeless = {choosing("own", 4, 1e-7, 10)};
  hopeless[0].finest = 16;
  CHECK(!asked(hopeless, 1e-9).winner.has_value());
}

TEST_CASE("Of two that choose their steps or not, the cheaper one is promised") {
  const std::vector<Candidate> list = {method("even", 5, 1, 10), choosing("own", 4, 1, 9),
                                       choosing("dear", 4, 1, 20)};
  REQUIRE(asked(list, 1e-6).winner.has_value());
  CHECK(asked(list, 1e-6).winner->candidate->method == "own");
}

TEST_CASE(
    "The error that a method which chooses its steps has for a given cost is one at that cost") {
  const std::vector<Candidate> list = {choosing("own", 4, 1, 10)};
  const Advisor advisor(list, frames, longest_run);
  for (const double most : {300.0, 2500.0, 1e5}) {
    const auto found = advisor.best_for(most, {.angle = 1});
    REQUIRE(found.has_value());
    CHECK(found->nanoseconds <= most);
    CHECK(found->errors.angle == list[0].errors(found->fineness, 0).angle);
  }
  CHECK(!advisor.best_for(50, {.angle = 1}).has_value());
  // Where the cost grows as the square, 25 times the fineness is too much for 25 times the cost.
  std::vector<Candidate> square = {list[0]};
  square[0].nanoseconds = [](long fineness, int) {
    return 100 * static_cast<double>(fineness * fineness);
  };
  const auto found = Advisor(square, frames, longest_run).best_for(2500, {.angle = 1});
  REQUIRE(found.has_value());
  CHECK(found->fineness == 4);  // 25, 19, 15, 11, 8, 6: a fifth less each time, and one
  CHECK(found->nanoseconds == 1600);
  // What is dearer when it is measured again does not do.
  int measured = 0;
  square[0].nanoseconds = [&](long, int) { return ++measured == 1 ? 100 : 1000; };
  CHECK(!Advisor(square, frames, longest_run).best_for(500, {.angle = 1}).has_value());
}

TEST_CASE("For a given cost the advisor finds the least error, and for none the least cost") {
  const std::vector<Candidate> list = {method("first order", 1, 1, 10),
                                       method("fourth order", 4, 0.1, 100)};
  const Advisor advisor(list, frames, longest_run);
  // 10 frames a second: 300 ns are 30 ns a frame, three steps of the first.
  const auto cheap = advisor.best_for(300, {.angle = 1});
  REQUIRE(cheap.has_value());
  CHECK(cheap->candidate->method == "first order");
  CHECK(cheap->fineness == 3);
  CHECK(cheap->nanoseconds == 300);
  CHECK(advisor.best_for(3000, {.angle = 1})->candidate->method == "fourth order");
  CHECK(!advisor.best_for(50, {.angle = 1}).has_value());
  Candidate exact = method("exact", 0, 1e-15, 500);
  exact.takes_steps = false;
  const std::vector<Candidate> exact_alone = {exact};
  const Advisor with_exact(exact_alone, frames, longest_run);
  CHECK(!with_exact.best_for(300, {.angle = 1}).has_value());
  CHECK(with_exact.best_for(6000, {.angle = 1})->fineness == 1);
  CHECK(advisor.least({.angle = 1})->candidate->method == "first order");
  std::vector<Candidate> odd = {method("failed", 1, INFINITY, 1), method("coarse", 1, 1, 10)};
  odd[1].finest = 3;
  const Advisor of_odd(odd, frames, longest_run);
  CHECK(of_odd.least({.angle = 1})->candidate->method == "coarse");
  CHECK(of_odd.best_for(3000, {.angle = 1})->fineness == 3);
}
