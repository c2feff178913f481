// Do bodies that have all but stopped cost more per step than moving ones?
#include <chrono>
#include <course/record.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

const int count = 4096;

/// Damping as one writes it first. It stops at no speed, however small.
template <class Real>
struct NaiveDamping {
  static constexpr std::string_view name = "naive damping", reads{}, writes = "velocity";
  static constexpr Phase phase = Phase::damping;
  Real fraction;
  std::string_view why_skipped(const Facts&) const { return ""; }
  void act(Particle<Real>& centre, const Moment<Real>&) const { centre.velocity *= fraction; }
  template <class Wide>
  NaiveDamping<Wide> widened() const {
    return {fraction};
  }
};
template <class Real>
struct NaiveSpinDamping {
  static constexpr std::string_view name = "naive damping of spin", reads{},
                                    writes = "angular momentum";
  static constexpr Phase phase = Phase::damping;
  Real fraction;
  std::string_view why_skipped(const Facts&) const { return ""; }
  void act(Top<Real>& top, const Moment<Real>&) const { top.angular_momentum_body *= fraction; }
  template <class Wide>
  NaiveSpinDamping<Wide> widened() const {
    return {fraction};
  }
};

/// Boxes that all move and turn at about `speed` (m/s and rad/s), hardly damped: they keep it.
template <class Real>
ManyBodies<Real> boxes(double speed, bool naive) {
  ManyBodies<Real> world(steps_per_second(60));
  const auto box = mass_properties(Box<Real>{{Real(0.1), Real(0.2), Real(0.3)}}, 2);
  for (int n = 0; n < count; ++n)
    world.add("box " + std::to_string(n),
              make_rigid_body<Real>("box", box, {}, Vec3d(speed, speed, speed).cast<Real>(),
                                    Vec3d(speed, 2 * speed, 3 * speed).cast<Real>())
                  .body);
  if (naive) {
    world.add(NaiveDamping<Real>{.fraction = 1 - std::numeric_limits<Real>::epsilon()});
    world.add(NaiveSpinDamping<Real>{.fraction = 1 - std::numeric_limits<Real>::epsilon()});
  } else {
    world.add(LinearDamping<Real>{.rate = Real(1e-6)});
    world.add(AngularDamping<Real>{.rate = Real(1e-6)});
  }
  return world;
}

/// ns for one body and one step, the best of several.
template <class Real>
double cost(ManyBodies<Real>& world) {
  using Clock = std::chrono::steady_clock;
  const int steps = 20;
  const auto begin = Clock::now();
  for (int n = 0; n < steps; ++n) world.step();
  return std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / steps / count;
}

template <class Real>
void run() {
  const double slowest = double(slowest_speed<Real>);
  std::vector<double> speeds = {1,
                                std::sqrt(slowest),
                                1e4 * slowest,
                                1e3 * slowest,
                                100 * slowest,
                                10 * slowest,
                                2 * slowest,
                                slowest / 2,
                                double(std::numeric_limits<Real>::min())};
  for (double naive : {0., 1.}) {
    std::vector<ManyBodies<Real>> worlds;
    for (double s : speeds) worlds.push_back(boxes<Real>(s, naive));
    std::vector<double> best(speeds.size(), 1e300);
    for (int round = 0; round < 20; ++round)
      for (std::size_t n = 0; n < speeds.size(); ++n) best[n] = std::min(best[n], cost(worlds[n]));
    for (std::size_t n = 0; n < speeds.size(); ++n)
      std::printf("%d naive %g  %8.1e  %6.2f ns  %.2f\n", int(sizeof(Real)), naive, speeds[n],
                  best[n], best[n] / best[0]);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  run<float>();
  run<double>();
}
