/// @file
/// In which portions to kick and drift: rows of numbers that make a splitting of order two one of
/// order four, six, eight or ten.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <tumble/scheme.hpp>

namespace tumble {

/// One step as portions of it: kicks[0], drifts[0], kicks[1], …, drifts[n − 1], kicks[n]. Each list
/// sums to 1, and reads the same backwards: the step is symmetric in time. "Kick" and "drift" stand
/// for any two motions that can each be made exactly.
template <std::size_t n, class Real = long double>
struct Alternation {
  std::array<Real, n + 1> kicks;
  std::array<Real, n> drifts;
};

/// The row of steps of the lengths w₁, …, wₙ, each half a kick, a drift and half a kick. Kicks that
/// meet are made as one. The first half of the weights and the middle one are given.
template <std::size_t half>
constexpr Alternation<2 * half - 1> composed(const std::array<long double, half>& weights) {
  constexpr std::size_t n = 2 * half - 1;
  Alternation<n> row = {};
  for (std::size_t i = 0; i < n; ++i) {
    row.drifts[i] = weights[i < half ? i : n - 1 - i];
    row.kicks[i] += row.drifts[i] / 2;
    row.kicks[i + 1] += row.drifts[i] / 2;
  }
  return row;
}

/// A row of its own portions: the first half of each list is given, and what stands in the middle
/// of one of them is what it lacks to 1.
template <std::size_t n>
constexpr Alternation<n> mirrored(const std::array<long double, (n + 1) / 2>& kicks,
                                  const std::array<long double, n / 2>& drifts) {
  Alternation<n> row = {};
  for (std::size_t i = 0; i < kicks.size(); ++i) row.kicks[i] = row.kicks[n - i] = kicks[i];
  for (std::size_t i = 0; i < drifts.size(); ++i) row.drifts[i] = row.drifts[n - 1 - i] = drifts[i];
  long double& middle = n % 2 == 0 ? row.kicks[n / 2] : row.drifts[n / 2];
  middle = 1;
  for (std::size_t i = 0; i < n / 2; ++i) middle -= 2 * (n % 2 == 0 ? row.kicks[i] : row.drifts[i]);
  return row;
}

/// Half a kick, a drift, half a kick: Strang (1968), Verlet (1967). Order 2.
//! [rows]
struct Verlet {
  static constexpr auto row = composed<1>({1});
};

/// p, p, 1 − 4p, p, p: Suzuki (1990). Order 4 for any symmetric step of order 2.
struct Suzuki {
  static constexpr auto row = composed<3>({suzuki_length, suzuki_length, 1 - 4 * suzuki_length});
};
//! [rows]

/// Seven steps, order 6: Yoshida (1990), solution A.
struct Yoshida {
  static constexpr auto row =
      composed<4>({0.784513610477557263819497633866L, 0.235573213359358133684793182979L,
                   -1.17767998417887100694641568096L, 1.31518632068391121888424972823L});
};

/// Nine steps, order 6: Kahan and Li (1997), s9odr6a.
struct KahanLiSixth {
  static constexpr auto row = composed<5>(
      {0.39216144400731413927925056L, 0.33259913678935943859974864L, -0.70624617255763935980996482L,
       0.08221359629355080023149045L, 0.79854399093482996339895035L});
};

/// Seventeen steps, order 8: Kahan and Li (1997), s17odr8a.
struct KahanLiEighth {
  static constexpr auto row = composed<9>(
      {0.13020248308889008087881763L, 0.56116298177510838456196441L, -0.38947496264484728640807860L,
       0.15884190655515560089621075L, -0.39590389413323757733623154L, 0.18453964097831570709183254L,
       0.25837438768632204729397911L, 0.29501172360931029887096624L,
       -0.60550853383003451169892108L});
};

/// Thirty-five steps, order 10: Sofroniou and Spaletta (2005).
struct SofroniouSpaletta {
  static constexpr auto row = composed<18>(
      {0.07879572252168641926390768L, 0.31309610341510852776481247L, 0.02791838323507806610952027L,
       -0.22959284159390709415121340L, 0.13096206107716486317465686L,
       -0.26973340565451071434460973L, 0.07497334315589143566613711L, 0.11199342399981020488957508L,
       0.36613344954622675119314812L, -0.39910563013603589787862981L, 0.10308739852747107731580277L,
       0.41143087395589023782070412L, -0.00486636058313526176219566L,
       -0.39203335370863990644808194L, 0.05194250296244964703718290L, 0.05066509075992449633587434L,
       0.04967437063972987905456880L, 0.04931773575959453791768001L});
};

/// Six drifts, order 4, for a kick and a drift that are each exact: Blanes and Moan (2002), S6.
struct BlanesMoanFourth {
  static constexpr auto row =
      mirrored<6>({0.0792036964311957L, 0.353172906049774L, -0.0420650803577195L},
                  {0.209515106613362L, -0.143851773179818L, 0.434336666566456L});
};

/// Ten drifts, order 6, likewise: Blanes and Moan (2002), S10.
struct BlanesMoanSixth {
  static constexpr auto row =
      mirrored<10>({0.0502627644003922L, 0.413514300428344L, 0.0450798897943977L,
                    -0.188054853819569L, 0.541960678450780L},
                   {0.148816447901042L, -0.132385865767784L, 0.067307604692185L, 0.432666402578175L,
                    -0.016404589403618L});
};

/// Eleven drifts, order 6, where the kicks change velocities by forces of place alone: Blanes and
/// Moan (2002), SRKN11.
struct BlanesMoanNystrom {
  static constexpr auto row =
      mirrored<11>({0.0414649985182624L, 0.198128671918067L, -0.0400061921041533L,
                    0.0752539843015807L, -0.0115113874206879L, 0.2366699247869311L},
                   {0.123229775946271L, 0.290553797799558L, -0.127049212625417L,
                    -0.246331761062075L, 0.357208872795928L});
};

/// The portions of a row as numbers of the kind that the step computes with.
template <class Row, class Real>
constexpr auto portions = [] {
  constexpr auto from = Row::row;
  Alternation<from.drifts.size(), Real> row = {};
  for (std::size_t i = 0; i < from.kicks.size(); ++i)
    row.kicks[i] = static_cast<Real>(from.kicks[i]);
  for (std::size_t i = 0; i < from.drifts.size(); ++i)
    row.drifts[i] = static_cast<Real>(from.drifts[i]);
  return row;
}();

/// Calls `kick` and `drift` in turn with the lengths that `Row` says, in the unit of `time_step`.
//! [alternate]
template <class Row, class Real, class Kick, class Drift>
void alternate(Real time_step, const Kick& kick, const Drift& drift) {
  using Number = decltype(std::numeric_limits<Real>::max());  // of a pack: that of each body
  constexpr auto& portion = portions<Row, Number>;
  for (std::size_t i = 0; i < portion.drifts.size(); ++i) {
    kick(portion.kicks[i] * time_step);
    drift(portion.drifts[i] * time_step);
  }
  kick(portion.kicks.back() * time_step);
}
//! [alternate]

}  // namespace tumble
