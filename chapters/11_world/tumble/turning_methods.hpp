/// @file
/// By which rule the bodies of a world turn whose moments differ: a type for each rule, and lists
/// of them to choose from by name.
#pragma once

#include <array>
#include <concepts>
#include <string_view>
#include <tumble/tumbling.hpp>

namespace tumble {

/// A rule that a world can turn by: a name, and a function of a top and a time step (s). One that
/// takes a Top of any Real is run on packs too (chapter 12); one that takes a single kind of number
/// visits the bodies of a pack one after another.
///
/// Where a rule finds no finite turn it should leave NaN; the world then takes the step back.
///
/// It may also say of which `order` it is, and that it is symmetric in time (`is_symmetric`): a
/// step back by it undoes a step forth. A plan that is not told counts on nothing.
//! [turning_rule]
template <class Rule, class Real>
concept TurningRule = requires(const Rule& rule, Top<Real>& top, const Real& time_step) {
  rule(top, time_step);
  { Rule::name } -> std::convertible_to<std::string_view>;
};
//! [turning_rule]

/// Sphere + axial + residual splitting: the world's own choice.
//! [turning_methods]
struct Splitting {
  static constexpr std::string_view name = "splitting";
  static constexpr int order = 2;
  static constexpr bool is_symmetric = true;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_by_splitting(top, time_step);
  }
};
//! [turning_methods]

/// The same without a sine, in less time, for angles that are small.
struct SplittingWithoutSine {
  static constexpr std::string_view name = "splitting without sine";
  static constexpr int order = 2;
  static constexpr bool is_symmetric = true;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_by_splitting_without_sine(top, time_step);
  }
};

/// The energy as three, one for each body axis, and a turn about each in turn: turn_axis_by_axis().
/// The top's L is in body axes (kg m²/s), the time step in s, as for every rule of this list.
/// Second order; McLachlan (1993), Reich (1994).
struct AxisByAxis {
  static constexpr std::string_view name = "axis by axis";
  static constexpr int order = 2;
  static constexpr bool is_symmetric = true;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_axis_by_axis(top, time_step);
  }
};

/// Turns by |ω| h about the present ω while L (kg m²/s) stands still in world axes, for a time step
/// of h seconds: turn_carrying_momentum(). First order, and exact in L.
struct CarryingMomentum {
  static constexpr std::string_view name = "carrying momentum";
  static constexpr int order = 1;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_carrying_momentum(top, time_step);
  }
};

/// Euler's equations in body axes by implicit Euler, solved by one step of Newton's method for a
/// time step in s: turn_implicitly(). First order, and it loses energy.
struct ImplicitNewton {
  static constexpr std::string_view name = "implicit Newton";
  static constexpr int order = 1;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_implicitly(top, time_step);
  }
};

/// Explicit Euler for L in body axes (kg m²/s) over a time step in s, with |L| scaled back to what
/// it was: turn_restoring_momentum(). First order; nothing restores the energy.
struct RestoringMomentum {
  static constexpr std::string_view name = "restoring momentum";
  static constexpr int order = 1;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_restoring_momentum(top, time_step);
  }
};

/// Euler's equations in body axes by explicit Euler, L ← L + h L × ω (kg m²/s) for a time step of
/// h seconds: turn_explicitly(). First order; |L| and the energy grow without bound.
struct ExplicitEuler {
  static constexpr std::string_view name = "explicit Euler";
  static constexpr int order = 1;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_explicitly(top, time_step);
  }
};

/// Without gyroscopic motion: turns by |ω| h about ω, and keeps L (kg m²/s) in body axes, for a
/// time step of h seconds: turn_steadily().
struct Steady {
  static constexpr std::string_view name = "steady";
  static constexpr int order = 0;
  template <class Real>
  void operator()(Top<Real>& top, Same<Real> time_step) const {
    turn_steadily(top, time_step);
  }
};

/// Rules that one can choose from while a program runs. Only what a list names is compiled, so
/// whoever wants more rules makes a longer list, and nobody else pays for it.
template <class... Rules>
struct TurningRules {
  static constexpr std::array<std::string_view, sizeof...(Rules)> names = {Rules::name...};

  /// Makes the world turn by rule number `index` of the list, less than its length.
  template <class AnyWorld>
  static void choose(AnyWorld& world, std::size_t index);
};

template <class... Rules>
template <class AnyWorld>
void TurningRules<Rules...>::choose(AnyWorld& world, std::size_t index) {
  std::size_t n = 0;
  const auto offer = [&](const auto& rule) {
    if (n++ == index) world.turn_by(rule);
  };
  (offer(Rules{}), ...);
}

/// Those of chapter 8.
using FirstTurningRules =
    TurningRules<Splitting, SplittingWithoutSine, AxisByAxis, CarryingMomentum, ImplicitNewton,
                 RestoringMomentum, ExplicitEuler, Steady>;

}  // namespace tumble
