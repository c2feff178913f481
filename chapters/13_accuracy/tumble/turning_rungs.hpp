/// @file
/// The rungs of the ladder that a world offers to turn its bodies by, beside chapter 8's.
#pragma once

#include <tumble/compositions.hpp>
#include <tumble/linearly_implicit.hpp>
#include <tumble/turning_methods.hpp>

namespace tumble {

struct LinearlyImplicit {
  static constexpr std::string_view name = "linearly implicit";
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_linearly_implicitly(top, time_step);
  }
};

/// Chapter 8's splitting in the portions of a row.
//! [in_row]
template <class Row>
struct SplittingInRow {
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_by_row<Row>(top, time_step);
  }
};

struct SplittingSuzuki : SplittingInRow<Suzuki> {
  static constexpr std::string_view name = "splitting, Suzuki";
};
//! [in_row]
struct SplittingBlanesMoanFourth : SplittingInRow<BlanesMoanFourth> {
  static constexpr std::string_view name = "splitting, Blanes-Moan 4";
};
struct SplittingYoshida : SplittingInRow<Yoshida> {
  static constexpr std::string_view name = "splitting, Yoshida";
};
struct SplittingBlanesMoanSixth : SplittingInRow<BlanesMoanSixth> {
  static constexpr std::string_view name = "splitting, Blanes-Moan 6";
};
struct SplittingKahanLiEighth : SplittingInRow<KahanLiEighth> {
  static constexpr std::string_view name = "splitting, Kahan-Li 8";
};
struct SplittingSofroniouSpaletta : SplittingInRow<SofroniouSpaletta> {
  static constexpr std::string_view name = "splitting, Sofroniou-Spaletta";
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
