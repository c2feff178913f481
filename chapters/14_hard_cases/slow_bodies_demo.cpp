// Do bodies that have all but stopped cost more per step than moving ones?
#include <chrono>
#include <support/record.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

const int count = 4096;

/// Damping as one writes it first. It stops at no speed, however small.
template <class Real>
struct NaiveDamping {
  static constexpr std::string_view name = "naive damping";
  static constexpr Phase phase = Phase::damping;
  Real fraction;
  std::string_view skip_reason(const BodyFlags&) const { return ""; }
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    return fraction * centre.velocity;
  }
  template <class Wide>
  NaiveDamping<Wide> broadcast() const {
    return {fraction};
  }
};
template <class Real>
struct NaiveSpinDamping {
  static constexpr std::string_view name = "naive damping of spin";
  static constexpr Phase phase = Phase::damping;
  Real fraction;
  std::string_view skip_reason(const BodyFlags&) const { return ""; }
  Vec3<Real> angular_momentum_body(const Top<Real>& top, const StepTime<Real>&) const {
    return fraction * top.angular_momentum_body;
  }
  template <class Wide>
  NaiveSpinDamping<Wide> broadcast() const {
    return {fraction};
  }
};

/// Boxes that all move and turn at about `speed` (m/s and rad/s), hardly damped: they keep it.
ManyBodies<float> boxes(float speed, bool naive) {
  ManyBodies<float> world(steps_per_second(60));
  const auto box = mass_properties(Box<float>{{0.1f, 0.2f, 0.3f}}, 2);
  const Vec3f velocity = speed * Vec3f(1, 1, 1), spin = speed * Vec3f(1, 2, 3);
  for (int n = 0; n < count; ++n)
    world.add("box " + std::to_string(n),
              make_rigid_body<float>("box", box, {}, velocity, spin).body);
  if (naive) {
    const float fraction = 1 - std::numeric_limits<float>::epsilon();
    world.add(NaiveDamping<float>{fraction});
    world.add(NaiveSpinDamping<float>{fraction});
  } else {
    world.add(LinearDamping<float>{.rate = 1e-6f});
    world.add(AngularDamping<float>{.rate = 1e-6f});
  }
  return world;
}

/// ns for one body and one step.
double cost(ManyBodies<float>& world) {
  using Clock = std::chrono::steady_clock;
  const int steps = 20;
  const auto begin = Clock::now();
  for (int n = 0; n < steps; ++n) world.step();
  return std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / steps / count;
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  const float slowest = slowest_speed<float>, smallest = std::numeric_limits<float>::min();
  const std::array<float, 7> speeds = {1,      1e-6f,  2 * slowest, slowest / 2,
                                       1e-12f, 1e-20f, smallest / 4};
  std::vector<ManyBodies<float>> worlds;
  for (const bool naive : {false, true})
    for (const float speed : speeds) worlds.push_back(boxes(speed, naive));
  // The best of many rounds: whatever else the machine does, it does to all of them.
  const int rounds = std::getenv("TUMBLE_FULL") != nullptr ? 200 : 30;
  std::vector<double> best(worlds.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t n = 0; n < worlds.size(); ++n) best[n] = std::min(best[n], cost(worlds[n]));

  Table table =
      notebook.table("slow_bodies", {"speed (m/s, rad/s)", "with damp()", "multiplied alone"});
  std::printf(
      "the time of a step against that of moving bodies\n\nspeed      damp()  multiplied alone\n");
  double dearest = 0, dearest_naive = 0;
  for (std::size_t n = 0; n < speeds.size(); ++n) {
    const double damped = best[n] / best[0], naive = best[n + speeds.size()] / best[speeds.size()];
    std::printf("%-8.1e   %5.2f  %5.2f\n", double(speeds[n]), damped, naive);
    table.row(number("%.0e", double(speeds[n])), number("%.2f", damped), number("%.2f", naive));
    dearest = std::max(dearest, damped);
    dearest_naive = std::max(dearest_naive, naive);
  }
  notebook.value("dearest", number("%.2f", dearest));
  notebook.value("dearest_naive", number("%.2f", dearest_naive));
  notebook.value("moving", number("%.1f ns", best[0]));
  notebook.value("bodies", std::to_string(count));
}
