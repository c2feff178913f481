// An `if` in a pack, live: balls bounce on soft ground, and whoever touches it is pushed. A pack
// takes both branches, and the lanes in the air wait for those on the ground.
#include <algorithm>
#include <array>
#include <random>
#include <support/live.hpp>
#include <tumble/pack.hpp>

using namespace tumble;

namespace {

using Column = std::vector<double>;

constexpr int balls = 128, steps = 240;
constexpr double time_step = 1 / 120.0;  // s

struct Bounce {
  double ground;               ///< ω of a ball on it, rad/s: √(k/m)
  std::vector<double> height;  ///< from which each ball falls, m
};

/// What is counted of one width: balls on the ground, and packs that hold one of them, step by
/// step; which balls they are, for the width that is shown.
struct Count {
  Column on_ground, packs;
  Column touching;
};

template <int width>
Count counted(const Bounce& bounce) {
  using Real = Pack<double, width>;
  Count count;
  std::vector<Real> z(balls / width), v(balls / width, Real(0));
  for (int ball = 0; ball < balls; ++ball)
    z[static_cast<std::size_t>(ball / width)].lanes[ball % width] =
        bounce.height[static_cast<std::size_t>(ball)];
  for (int n = 0; n < steps; ++n) {
    int on_ground = 0, packs = 0;
    for (std::size_t pack = 0; pack < z.size(); ++pack) {
      const auto touches = z[pack] < Real(0);
      int lanes = 0;
      for (int lane = 0; lane < width; ++lane) {
        lanes += touches[lane];
        count.touching.push_back(touches[lane]);
      }
      on_ground += lanes;
      packs += lanes > 0;
      // Both branches, and for each ball the one that applies to it.
      const Real push =
          select(touches, Real(-bounce.ground * bounce.ground) * z[pack], Real(0));  // m/s²
      v[pack] += Real(time_step) * (Real(-9.81) + push);
      z[pack] += Real(time_step) * v[pack];
    }
    count.on_ground.push_back(on_ground);
    count.packs.push_back(packs);
  }
  return count;
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const int shown = live.choice("width", 2, 5);  // 2 to this power
  const int order = live.choice("order", 0, 3);
  Bounce bounce{.ground = live.knob("ground", "rad/s", 50, 20, 100), .height = {}};
  live.knob("branch", "", 4, 1, 20);
  std::mt19937_64 dice(12);
  for (int ball = 0; ball < balls; ++ball)
    bounce.height.push_back(0.2 + std::ldexp(static_cast<double>(dice() >> 11), -53));
  if (order == 1) std::sort(bounce.height.begin(), bounce.height.end());
  if (order == 2) bounce.height.assign(balls, 0.7);
  const std::array counts = {counted<1>(bounce), counted<2>(bounce), counted<4>(bounce),
                             counted<8>(bounce), counted<16>(bounce)};
  Column &time = live.column("time", "s"), &on_ground = live.column("on the ground", "");
  for (int n = 0; n < steps; ++n) time.push_back(n * time_step);
  on_ground = counts[0].on_ground;
  Column& totals = live.column("packs of each width", "");
  for (const Count& count : counts) {
    double total = 0;
    for (const double packs : count.packs) total += packs;
    totals.push_back(total);
  }
  const Count& count = counts[static_cast<std::size_t>(shown)];
  live.column("packs", "") = count.packs;
  live.column("touching", "") = count.touching;
}
