#include <exercise/judge.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition tick_and_workers[] = {{"sum_on", 1, powers_of_two}, {"sum_on", 2, 1, 64}};

/// Momenta of very different size, 2^-10 to 2^9, of both signs.
template <class Real>
std::vector<Real> momenta(int count) {
  std::vector<Real> values;
  std::uint32_t state = 2463534242;  // G. Marsaglia's xorshift, with his own start
  for (int n = 0; n < count; ++n) {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    const double part = state / 4294967296.0 - 0.5;
    values.push_back(static_cast<Real>(std::ldexp(part, static_cast<int>(state % 20) - 9)));
  }
  return values;
}

const double fine_tick = std::ldexp(1.0, -20);

template <class Real>
Real sum_on(const std::vector<Real>& values, double tick, int workers) {
  return ask<Real>("sum_on", values, Real(tick), workers);
}

template <class Real>
double exact_sum(const std::vector<Real>& values) {
  long double sum = 0;
  for (const Real value : values) sum += static_cast<long double>(value);
  return static_cast<double>(sum);
}

/// A worker that sums too many values, or too few, rounds none of them wrongly.
template <class Real>
void require_shares() {
  // Powers of four, so that the sum tells how often each value is in it.
  Found("the sum that two workers make of 1, 4, 16, 64 and 256 ticks", "ticks",
        sum_on<Real>({1, 4, 16, 64, 256}, 1, 2))
      .mistake(341 + 16,
               "16 is in it twice. Where one share ends the next begins: values[last] is the next "
               "worker's")
      .mistake(341 - 4 - 256,
               "each worker leaves out the last of its share, which is values[last - 1]")
      .mistake(341 - 1 - 16, "each worker leaves out the first of its share")
      .must_be(341, 0);
}

}  // namespace

EXERCISE_CHECK("Any number of workers makes the same sum, to the bit") {
  require_shares<Real>();
  const auto values = momenta<Real>(2000);
  const Real alone = sum_on<Real>(values, fine_tick, 1);
  require(std::abs(double(alone) - exact_sum(values)) < 1,
          sentence("one worker sums two thousand momenta to ", alone, " kg m/s; it must be near ",
                   exact_sum(values)));
  for (const int workers : {2, 3, 4, 7, 64}) {
    const Real together = sum_on<Real>(values, fine_tick, workers);
    require(together == alone,
            sentence("one worker finds ", alone, " kg m/s and ", workers, " find ", together,
                     ". What does a worker lose that another would not? A worker that rounds its "
                     "*sum* rounds another number than the next; round each value, and sum whole "
                     "numbers"));
  }
}

EXERCISE_CHECK("The bodies may stand in any order") {
  may_be_off() = 1.0 / 256;  // of the ticks the check itself tells, in float if not in double
  auto values = momenta<Real>(2000);
  const Real sum = sum_on<Real>(values, fine_tick, 3);
  require(std::abs(double(sum) - exact_sum(values)) < 1,
          sentence("three workers sum two thousand momenta to ", sum, " kg m/s; it must be near ",
                   exact_sum(values)));
  const auto look = [&](const char* order) {
    const Real other = sum_on<Real>(values, fine_tick, 3);
    require(other == sum,
            sentence("the same bodies ", order, " have ", other, " kg m/s in place of ", sum,
                     ". Is something added up before it is a whole number?"));
  };
  std::reverse(values.begin(), values.end());
  look("from the last to the first");
  std::sort(values.begin(), values.end());
  look("sorted by momentum");
}

EXERCISE_CHECK("The sum is off by at most half a tick for each value, either way") {
  may_be_off() = 1.0 / 256;  // of the ticks the check itself tells, in float if not in double
  require_shares<Real>();
  const auto of = [](Real each, int count) {
    return sum_on<Real>(std::vector<Real>(static_cast<std::size_t>(count), each), 1, 2);
  };
  Found("the sum of a hundred times -0.25 ticks, each rounded to the nearest,", "ticks",
        of(Real(-0.25), 100))
      .mistake(-100, "each was rounded down. The nearest to -0.25 is 0")
      .must_be(0, 0);
  Found("the sum of a hundred times 0.75 ticks, each rounded to the nearest,", "ticks",
        of(Real(0.75), 100))
      .mistake(0, "each lost its digits: a cast cuts them off. Take the nearest, with std::llround")
      .mistake(75, "nothing was rounded. Then how is the sum one of whole numbers?")
      .must_be(100, 0);
  Found("the sum of a hundred times -0.75 ticks, each rounded to the nearest,", "ticks",
        of(Real(-0.75), 100))
      .mistake(0, "each lost its digits: a cast cuts them off. Take the nearest, with std::llround")
      .mistake(-75, "nothing was rounded. Then how is the sum one of whole numbers?")
      .must_be(-100, 0);
  // From 2^23 on a float has no halves: to add one rounds, and here to the next even number.
  const Real odd = Real(0x1p23) + 1;
  Found("the sum of 2^23 + 1 ticks, which is a whole number already,", "ticks",
        sum_on<Real>({odd}, 1, 1))
      .mistake(odd + 1, "adding a half before cutting off rounds in that sum. std::llround doesn't")
      .must_be(odd, 0);
  const auto values = momenta<Real>(2000);
  const double truth = exact_sum(values), found = double(sum_on<Real>(values, fine_tick, 4));
  // Half a tick a value, and the one rounding of the result.
  const double bound = 2000 * fine_tick / 2 + unit_roundoff<Real> * std::abs(truth);
  require(std::abs(found - truth) <= bound,
          sentence("two thousand momenta sum to ", found, " kg m/s; it must be ", truth,
                   ". That is off by ", std::abs(found - truth),
                   ", and half a tick for each allows ", bound));
}

EXERCISE_CHECK("What is not a number or beyond 2^40 ticks is refused, what is just within is not") {
  const auto refused = [](Real value, const std::string& what) {
    ask_refusal("a summand of " + what + " was summed. " +
                    (std::isnan(value)
                         ? "No comparison with NaN is true; ask whether it *is* within, and "
                           "refuse if not"
                         : "A conversion to an integer that doesn't fit is undefined: refuse it "
                           "before"),
                "sum_on", std::vector<Real>{1, value, 2}, Real(1), 2);
  };
  const Real most = std::ldexp(Real(1), 40);
  refused(std::numeric_limits<Real>::infinity(), "infinity");
  refused(most + std::ldexp(Real(1), 18), "2^40 + 2^18 ticks");
  refused(std::ldexp(Real(1), 41), "2^41 ticks");
  refused(-std::ldexp(Real(1), 70), "-2^70 ticks");
  refused(std::numeric_limits<Real>::quiet_NaN(), "NaN");
  Found("the sum of 2^40, 3 and -2^40 ticks", "ticks", sum_on<Real>({most, 3, -most}, 1, 2))
      .must_be(3, 0);
  Found("the sum of 2^40 ticks alone", "ticks", sum_on<Real>({most}, 1, 2)).must_be(most, 0);
  ask_refusal(
      "with a tick of 2^-10 kg m/s, 2^35 kg m/s were summed, which are 2^45 ticks. Ask how "
      "many ticks it is, not how many kg m/s",
      "sum_on", std::vector<Real>{1, std::ldexp(Real(1), 35), 2}, Real(0x1p-10), 2);
  Found("with a tick of 4 kg m/s, the sum of 2^41, 12 and -2^41 kg m/s", "kg m/s",
        sum_on<Real>({2 * most, 12, -2 * most}, 4, 2))
      .must_be(12, 0);
}
