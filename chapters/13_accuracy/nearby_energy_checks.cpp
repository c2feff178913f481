#include <support/checks.hpp>
#include <support/problems.hpp>
#include <tumble/paced_steps.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Wide = long double;

/// How far a quantity wavers: its largest value less its smallest one.
struct Wavering {
  Wide least = std::numeric_limits<Wide>::infinity(), most = -least;
  void see(Wide value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  Wide width() const { return most - least; }
};

/// What h² stands before, for the splitting with a sphere: {B,{B,A}}/12 − {A,{A,B}}/24 with
/// A = ½ β L_b² and B = ½ γ L_c², by {L_b, L_c} = −L_a and round the axes.
Wide second_term(const Top<Wide>& top) {
  const auto& i = top.inverse_moments;
  const Wide beta = i[1] - i[0], gamma = i[2] - i[0];
  const Vec3<Wide> square = top.angular_momentum_body.cwiseAbs2();
  return beta * gamma / 24 *
         (2 * gamma * square[2] * (square[0] - square[1]) +
          beta * square[1] * (square[2] - square[0]));
}

constexpr double angle = 0.1, least = 4, even_step = 0.02;  // s, about the mean of the paced ones

/// Steps of an asymmetric top that follow its pace, and as many of one length; the energy of both.
class PacedAndEven {
 public:
  explicit PacedAndEven(const Topd& start, const OffAxisWeight<double>& weight)
      : weight_(weight), paced_(start, weight, 0, angle, least), even_(start) {
    weight_(even_, 0);
  }
  /// The mean energies of so many steps, J.
  std::array<double, 2> mean_energies(int steps) {
    std::array<double, 2> mean{};
    for (int n = 0; n < steps; ++n) {
      paced_.step();
      step_by_row<Verlet>(even_, weight_, 0.0, even_step);
      mean[0] += double(weight_.kept(exactly(paced_.top())).energy) / steps;
      mean[1] += double(weight_.kept(exactly(even_)).energy) / steps;
    }
    return mean;
  }
  const Topd& even() const { return even_; }

 private:
  const OffAxisWeight<double>& weight_;
  PacedSteps<Verlet, OffAxisWeight<double>, double> paced_;
  Topd even_;
};

}  // namespace

TEST_CASE("A splitting keeps a nearby energy: with the term in h² the error is one of h⁴") {
  for (const TumblingProblem* problem : {&tumbling_problems[0], &tumbling_problems[1]}) {
    CAPTURE(problem->letter);
    const auto wavers = [&](Wide h) {
      Top<Wide> top = top_of<Wide>(*problem);
      Wavering energy, nearby;
      for (Wide time = 0; time < 30; time += h) {  // several rounds of L in the body
        turn_by_splitting(top, h);
        energy.see(kinetic_energy(top));
        nearby.see(kinetic_energy(top) + h * h * second_term(top));
      }
      return std::pair(energy.width(), nearby.width());
    };
    const auto [energy, nearby] = wavers(0.04L);
    const auto [energy_of_half, nearby_of_half] = wavers(0.02L);
    // The next even power is less by the square of the angle of a step, at the fastest spin that
    // the energy allows: |ω|² = 2E/I with the least I.
    const Top<Wide> start = top_of<Wide>(*problem);
    const Wide next = 0.04L * 0.04L * 2 * kinetic_energy(start) * start.inverse_moments.maxCoeff();
    CAPTURE(next);
    CHECK(std::abs(energy / energy_of_half / 4 - 1) <= next);
    CHECK(std::abs(nearby / nearby_of_half / 16 - 1) <= next);
    CHECK(nearby <= next * energy);
  }
}

TEST_CASE(
    "Without a mirror plane a top's energy drifts with steps that follow the pace, the other way "
    "when turned around, and not with steps of one length") {
  const auto problem = asymmetric_heavy_top<double>(0.15, 2);
  const auto drift = [&](double sense) {
    Topd start = problem.start;
    start.angular_momentum_body *= sense;
    PacedAndEven steps(start, problem.evaluate_forces);
    const auto first = steps.mean_energies(8'000);
    steps.mean_energies(48'000);
    const auto last = steps.mean_energies(8'000);
    return std::array{last[0] - first[0], last[1] - first[1]};
  };
  const auto forwards = drift(1), backwards = drift(-1);
  CAPTURE(forwards[0]);
  CAPTURE(backwards[0]);
  for (const double even : {forwards[1], backwards[1]})
    CHECK(20 * std::abs(even) <= std::min(forwards[0], -backwards[0]));
}

TEST_CASE(
    "With a mirror plane the energy of a chaotic top wanders with steps that follow the pace, as "
    "far up as down, and not with steps of one length") {
  const auto problem = asymmetric_heavy_top<double>(0, 1);
  // Eight starts that differ by a millionth, so that chaos makes eight motions of them. Where what
  // is added has no order, the spread of their energies grows as the square root of the steps.
  constexpr int starts = 8;
  std::array<std::array<double, starts>, 2> moved{};
  Topd first_even, second_even;
  for (std::size_t n = 0; n < starts; ++n) {
    Topd start = problem.start;
    start.angular_momentum_body.x() += 1e-6 * double(n);
    PacedAndEven steps(start, problem.evaluate_forces);
    const auto first = steps.mean_energies(1'000);
    steps.mean_energies(15'000);
    const auto last = steps.mean_energies(8'000);
    for (std::size_t which = 0; which < 2; ++which) moved[which][n] = last[which] - first[which];
    if (n == 0) first_even = steps.even();
    if (n == 1) second_even = steps.even();
  }
  CHECK(angle_between(first_even.orientation, second_even.orientation) > 0.1);
  std::array<double, 2> mean{}, spread{};
  for (std::size_t which = 0; which < 2; ++which) {
    for (const double value : moved[which]) mean[which] += value / starts;
    for (const double value : moved[which]) spread[which] += std::pow(value - mean[which], 2);
    spread[which] = std::sqrt(spread[which] / (starts - 1));
  }
  CHECK(spread[0] > 20 * spread[1]);
  CHECK(std::abs(mean[0]) <= 4 * spread[0] / std::sqrt(double(starts)));
}
