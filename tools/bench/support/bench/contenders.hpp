/// @file
/// Who is measured, in which scenes and with how many bodies.
#pragma once

#include <support/bench/measurements.hpp>
#include <support/bench/memory.hpp>
#include <support/bench/our_world.hpp>
#include <support/bench/pace.hpp>
#include <support/bench/plain_loop.hpp>
#ifdef TUMBLE_HAS_BULLET
#include <support/bench/bullet.hpp>
#endif
#ifdef TUMBLE_HAS_ODE
#include <support/bench/ode.hpp>
#endif

namespace tumble::support::bench {

/// How much is measured.
struct Extent {
  std::vector<std::size_t> counts;      ///< how many bodies, in float
  std::size_t most_in_double;           ///< and in double at most
  std::size_t most_of_peers;            ///< bodies of Bullet and ODE take most of a kilobyte each
  int repetitions;                      ///< of each measurement
  double time;                          ///< of one measurement, ns
  std::size_t count_of_effects = 4096;  ///< where each effect is measured alone
};

/// A few sizes, about one for each level of the memory; for every book.
inline Extent quick_extent() {
  return {.counts = {256, 1024, 4096, 16'384, 65'536, 1 << 18, 1 << 20},
          .most_in_double = 65'536,
          .most_of_peers = 65'536,
          .repetitions = 5,
          .time = 5e6};
}

/// From one body to four million.
inline Extent full_extent() {
  Extent full{.counts = {},
              .most_in_double = 1 << 22,
              .most_of_peers = 1 << 18,
              .repetitions = 7,
              .time = 4e7};
  for (std::size_t count = 1; count <= 1 << 22; count *= 4) full.counts.push_back(count);
  return full;
}

inline const std::string our_world = "our world";
inline const std::string our_cheapest = "our world, cheapest stable rule";
inline const std::string our_one_by_one = "our world, one by one";
inline const std::string bare_body = "one body without a world";
inline const std::string splitting_loop = "plain loop, splitting";
inline const std::string cayley_loop = "plain loop, no sine";
inline const std::string explicit_loop = "plain loop, explicit";
inline const std::string colliding_loop = "plain loop, explicit, columns a power of two apart";
inline const std::string memory_update = "memory, update";
inline const std::string memory_triad = "memory, triad";
inline const std::string bullet_functions = "Bullet's functions";
inline const std::string bullet_world = "Bullet's world";
inline const std::string ode_world = "ODE";
inline std::string without_gyroscopic(const std::string& peer) {
  return peer + ", gyroscopic term off";
}

/// What so many bodies of the plain loop take in float, bytes. The memory is measured with as much.
constexpr std::size_t bytes_of_bodies(std::size_t count) {
  return column_count * sizeof(float) * count;
}

template <class Real>
const std::string precision_of = std::is_same_v<Real, float> ? "float" : "double";

/// That which ODE was compiled for.
#ifdef TUMBLE_HAS_ODE
inline const std::string ode_precision = precision_of<dReal>;
#else
inline const std::string ode_precision = precision_of<double>;
#endif

/// Puts down what to measure.
class Contest {
 public:
  Contest(Measurements& measurements, const Extent& extent)
      : measurements_(measurements), extent_(extent) {
    in_precision<float>();
    in_precision<double>();
    for (const std::size_t count : extent_.counts) {
      plain<float, Scene::everything, Rule::explicit_euler>(colliding_loop, count, 1,
                                                            Spacing::power_of_two);
      for (const int threads : {1, 2}) {
        memory<Stream::update>(memory_update, count, threads);
        memory<Stream::triad>(memory_triad, count, threads);
      }
      if (count <= extent_.most_of_peers) peers(count);
    }
  }

  /// Steps timed one by one, of as many bodies as one effect is measured with.
  template <class Real>
  Pace pace() const;

 private:
  /// Bodies of which a step takes `time` ns or so each. What takes long to make is made twice: many
  /// bodies of a slow kind, and a million of any.
  template <class Bodies, class... Arguments>
  void add(const Case& subject, double time, const Arguments&... arguments) {
    const double steps = extent_.time / time / static_cast<double>(subject.count);
    const bool slow = subject.count > (time > 50 ? 16'384 : 500'000);
    measurements_.add(subject, slow ? 2 : extent_.repetitions,
                      static_cast<std::int64_t>(std::clamp(steps, 2., 1e5)),
                      [=] { return std::make_unique<Bodies>(arguments...); });
  }

  template <class Real>
  void in_precision();

  template <class Real, Scene scene>
  void each_effect(std::size_t count) {
    ours<Real>(scene, count, 1);
    plain<Real, scene, Rule::splitting>(splitting_loop, count);
    plain<Real, scene, Rule::cayley>(cayley_loop, count);
  }

  template <class Real, Scene scene, Rule rule>
  void plain(const std::string& name, std::size_t count, int threads = 1,
             Spacing spacing = Spacing::padded) {
    const Setting setting{.scene = scene, .count = count, .threads = threads};
    add<PlainBodies<Real, scene, rule>>({name, scene, precision_of<Real>, count, threads}, 5,
                                        setting, spacing);
  }

  template <class Real>
  void ours(Scene scene, std::size_t count, int threads) {
    if (count > OurWorld<Real>::most_bodies) return;
    const Setting setting{.scene = scene, .count = count, .threads = threads};
    add<OurWorld<Real>>({our_world, scene, precision_of<Real>, count, threads}, 100, setting);
    if (has_tops(scene))
      add<OurWorld<Real>>({our_cheapest, scene, precision_of<Real>, count, threads}, 100, setting,
                          OurWorld<Real>::cheapest_stable);
  }

  template <Stream stream>
  void memory(const std::string& name, std::size_t count, int threads) {
    add<Memory<stream>>({name, Scene::everything, "float", count, threads}, 5,
                        bytes_of_bodies(count), threads);
  }

  template <class Bodies>
  void peer(const std::string& name, const std::string& precision, std::size_t count) {
    for (const bool gyroscopic : {true, false}) {
      const Setting setting{.count = count, .gyroscopic = gyroscopic};
      add<Bodies>(
          {gyroscopic ? name : without_gyroscopic(name), Scene::everything, precision, count}, 300,
          setting);
    }
  }

  void peers([[maybe_unused]] std::size_t count) {
#ifdef TUMBLE_HAS_BULLET
    peer<BulletFunctions>(bullet_functions, "float", count);
    peer<BulletWorld>(bullet_world, "float", count);
#endif
#ifdef TUMBLE_HAS_ODE
    peer<OdeWorld>(ode_world, ode_precision, count);
#endif
  }

  Measurements& measurements_;
  Extent extent_;
};

template <class Real>
void Contest::in_precision() {
  for (const std::size_t count : extent_.counts) {
    if (std::is_same_v<Real, double> && count > extent_.most_in_double) break;
    plain<Real, Scene::everything, Rule::splitting>(splitting_loop, count);
    plain<Real, Scene::everything, Rule::splitting>(splitting_loop, count, 2);
    plain<Real, Scene::everything, Rule::cayley>(cayley_loop, count);
    plain<Real, Scene::everything, Rule::cayley>(cayley_loop, count, 2);
    plain<Real, Scene::everything, Rule::explicit_euler>(explicit_loop, count);
    plain<Real, Scene::points_under_gravity, Rule::splitting>(splitting_loop, count);
    for (int threads = 1; threads <= OurWorld<Real>::most_threads; ++threads)
      for (const Scene scene : {Scene::everything, Scene::points_under_gravity})
        ours<Real>(scene, count, threads);
  }
  const std::size_t count = extent_.count_of_effects;
  each_effect<Real, Scene::points_coasting>(count);
  each_effect<Real, Scene::tumbling>(count);
  each_effect<Real, Scene::tumbling_with_torque>(count);
  each_effect<Real, Scene::tumbling_with_damping>(count);
  constexpr Scene torqued = Scene::tumbling_with_torque;
  const Setting one{.scene = torqued};
  add<BareBody<Real>>({bare_body, torqued, precision_of<Real>}, 100, one);
  add<OurWorld<Real, OneByOne<Real>>>({our_one_by_one, torqued, precision_of<Real>}, 100, one);
  add<OurWorld<Real, OneByOne<Real>>>(
      {our_one_by_one, Scene::everything, precision_of<Real>, count}, 100, Setting{.count = count});
  ours<Real>(torqued, 1, 1);
}

template <class Real>
Pace Contest::pace() const {
  OurWorld<Real> world({.count = extent_.count_of_effects});
  return pace_of(world, 1000);
}

// Each in a file of its own: they are most of what there is to compile.
extern template void Contest::in_precision<float>();
extern template void Contest::in_precision<double>();
extern template Pace Contest::pace<float>() const;
extern template Pace Contest::pace<double>() const;

}  // namespace tumble::support::bench
