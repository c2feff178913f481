// What is not on the turning ladder, as functions of a top and a time step.
#include <support/other_methods.hpp>
#include <support/own_steps.hpp>
#include <tumble/splitting_without_sine.hpp>

namespace tumble::support {
namespace {

/// One of those that choose their steps, through a time step. Where no step will do there is no
/// state any more.
template <std::size_t n, class Real>
void turn_by_own_steps(Top<Real>& top, Same<Real> time_step) {
  const FreeTopRung<Real>& rung = free_top_rungs<Real>[n];
  const double given = rung.given == Given::angle ? given_angle : given_tolerance;
  try {
    rung.integrate(top, time_step, static_cast<Real>(given));
  } catch (const StepError&) {
    top.angular_momentum_body.setConstant(std::numeric_limits<Real>::quiet_NaN());
  }
}

template <class Real>
constexpr auto all_other_methods = [] {
  constexpr std::size_t of_one_length = 1 + even_momentum_ladder<Real>.size(),
                        own = free_top_rungs<Real>.size();
  std::array<TurningRung<Real>, of_one_length + own + 1> all = {
      {{"splitting without a sine", {.order = 2}, turn_by_splitting_without_sine<Real>}}};
  std::copy(even_momentum_ladder<Real>.begin(), even_momentum_ladder<Real>.end(), all.begin() + 1);
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    ((all[of_one_length + n] = {free_top_rungs<Real>[n].name, free_top_rungs<Real>[n].claims,
                                turn_by_own_steps<n, Real>}),
     ...);
  }
  (std::make_index_sequence<own>());
  all.back() = {"exact solution", {}, turn_exactly<Real>};
  return all;
}();

}  // namespace

template <>
std::span<const TurningRung<float>> other_methods<float>() {
  return all_other_methods<float>;
}
template <>
std::span<const TurningRung<double>> other_methods<double>() {
  return all_other_methods<double>;
}

}  // namespace tumble::support
