/// @file
/// The rungs of the ladder that a world offers to turn its bodies by, beside chapter 8's.
#pragma once

#include <tumble/compositions.hpp>
#include <tumble/linearly_implicit.hpp>
#include <tumble/turning_methods.hpp>

namespace tumble {

/// One solution of a linear equation for L in body axes (kg m²/s) for each time step (s):
/// turn_linearly_implicitly().
struct LinearlyImplicit {
  static constexpr std::string_view name = "linearly implicit";
  static constexpr int order = 1;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_linearly_implicitly(top, time_step);
  }
};

/// Chapter 8's splitting in the portions of a row (no unit): each is made with that part of the
/// time step (s), on a top with L in body axes (kg m²/s).
template <class Row>
struct ComposedSplitting {
  static constexpr bool is_symmetric = true;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_by_row<Row>(top, time_step);
  }
};

/// Order 4 in five steps: Suzuki (1990).
struct SplittingSuzuki : ComposedSplitting<Suzuki> {
  static constexpr std::string_view name = "splitting, Suzuki";
  static constexpr int order = 4;
};
/// Order 4: Blanes and Moan (2002), S6.
struct SplittingBlanesMoanFourth : ComposedSplitting<BlanesMoanFourth> {
  static constexpr std::string_view name = "splitting, Blanes-Moan 4";
  static constexpr int order = 4;
};
/// Order 6 in seven steps: Yoshida (1990), solution A.
struct SplittingYoshida : ComposedSplitting<Yoshida> {
  static constexpr std::string_view name = "splitting, Yoshida";
  static constexpr int order = 6;
};
/// Order 6: Blanes and Moan (2002), S10.
struct SplittingBlanesMoanSixth : ComposedSplitting<BlanesMoanSixth> {
  static constexpr std::string_view name = "splitting, Blanes-Moan 6";
  static constexpr int order = 6;
};
/// Order 8 in seventeen steps: Kahan and Li (1997), s17odr8a.
struct SplittingKahanLiEighth : ComposedSplitting<KahanLiEighth> {
  static constexpr std::string_view name = "splitting, Kahan-Li 8";
  static constexpr int order = 8;
};
/// Order 10 in thirty-five steps: Sofroniou and Spaletta (2005).
struct SplittingSofroniouSpaletta : ComposedSplitting<SofroniouSpaletta> {
  static constexpr std::string_view name = "splitting, Sofroniou-Spaletta";
  static constexpr int order = 10;
};

/// A list of rules with more of them.
template <class List, class... More>
struct Longer;
template <class... Rules, class... More>
struct Longer<TurningRules<Rules...>, More...> {
  using Type = TurningRules<Rules..., More...>;
};

/// Chapter 8's rules, and the rungs that stay finite wherever sine_cosine() reaches. Those that
/// look ahead or solve equations can leave the finite numbers within a single step of a few
/// radians, and the world would stop there; nobody would choose that for a scene.
//! [rungs_of_worlds]
using RungsOfWorlds = Longer<FirstTurningRules, LinearlyImplicit, SplittingSuzuki,
                             SplittingBlanesMoanFourth, SplittingYoshida, SplittingBlanesMoanSixth,
                             SplittingKahanLiEighth, SplittingSofroniouSpaletta>::Type;
//! [rungs_of_worlds]

}  // namespace tumble
