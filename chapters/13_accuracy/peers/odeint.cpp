#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <cmath>
#include <limits>
#include <peers/peers.hpp>

namespace odeint = boost::numeric::odeint;

namespace peers {
namespace {

/// Euler's equations and the rate of the quaternion.
template <Torque torque>
struct TopEquations {
  std::array<double, 3> i;
  double parameter;

  void operator()(const TopState& state, TopState& rate, double time) const {
    const auto [w, x, y, z, L0, L1, L2] = state;
    const double w0 = i[0] * L0, w1 = i[1] * L1, w2 = i[2] * L2;
    rate = {-0.5 * (x * w0 + y * w1 + z * w2),
            0.5 * (w * w0 + y * w2 - z * w1),
            0.5 * (w * w1 + z * w0 - x * w2),
            0.5 * (w * w2 + x * w1 - y * w0),
            L1 * w2 - L2 * w1,
            L2 * w0 - L0 * w2,
            L0 * w1 - L1 * w0};
    if constexpr (torque == Torque::weight) {
      // M g l (−y, x, 0) for the axis (x, y, z), seen from the body: it is perpendicular to the
      // axis.
      rate[4] += parameter * 2 * (y * z + w * x);
      rate[5] += parameter * 2 * (w * y - x * z);
    }
    if constexpr (torque == Torque::drive) {
      const double t0 = 0.6 * std::cos(2 * time), t1 = 0.4 * std::sin(3 * time), t2 = 0.3;
      const double u0 = 2 * (t1 * z - t2 * y), u1 = 2 * (t2 * x - t0 * z),
                   u2 = 2 * (t0 * y - t1 * x);
      rate[4] += t0 + w * u0 + (u1 * z - u2 * y);
      rate[5] += t1 + w * u1 + (u2 * x - u0 * z);
      rate[6] += t2 + w * u2 + (u0 * y - u1 * x);
    }
  }
};

template <Force force>
struct PointEquations {
  std::array<double, 2> parameters;

  void operator()(const PointState& state, PointState& rate, double) const {
    const auto [x, y, z, vx, vy, vz] = state;
    if constexpr (force == Force::gravity_and_drag) {
      const double c = parameters[1];
      rate = {vx, vy, vz, -c * vx, -c * vy, -parameters[0] - c * vz};
    } else {
      double pull = -parameters[0];
      if constexpr (force == Force::star) {
        const double square = x * x + y * y + z * z;
        pull /= square * std::sqrt(square);
      }
      rate = {vx, vy, vz, pull * x, pull * y, pull * z};
    }
  }
};

using Coordinates = std::array<double, 3>;

/// The same acceleration for a symplectic stepper, which takes place and velocity apart.
template <Force force>
struct Pull {
  std::array<double, 2> parameters;

  void operator()(const Coordinates& place, Coordinates& acceleration) const {
    PointState rate;
    PointEquations<force>{parameters}({place[0], place[1], place[2], 0, 0, 0}, rate, 0);
    acceleration = {rate[3], rate[4], rate[5]};
  }
};

/// Odeint's symplectic steppers, for forces of place alone.
template <Force force>
void append_symplectic(std::vector<Peer<PointState>>& list, const std::array<double, 2>& parameters,
                       const PointState& start, double seconds) {
  const auto add = [&]<class Stepper>(const char* name, Stepper) {
    list.push_back({name, false, [=](double knob) {
                      std::pair<Coordinates, Coordinates> state = {{start[0], start[1], start[2]},
                                                                   {start[3], start[4], start[5]}};
                      odeint::integrate_n_steps(Stepper(), Pull<force>{parameters}, state, 0.0,
                                                seconds / knob, static_cast<std::size_t>(knob));
                      const auto& [x, v] = state;
                      return PointState{x[0], x[1], x[2], v[0], v[1], v[2]};
                    }});
  };
  add("symplectic Euler", odeint::symplectic_euler<Coordinates>());
  add("McLachlan, 4 stages", odeint::symplectic_rkn_sb3a_m4_mclachlan<Coordinates>());
  add("McLachlan, 6 stages", odeint::symplectic_rkn_sb3a_mclachlan<Coordinates>());
}

/// NaN where the tolerance is so tight that no step meets it.
template <class Stepper, class Equations, class State>
State adapted(const Stepper& stepper, const Equations& equations, State state, double seconds) {
  try {
    odeint::integrate_adaptive(stepper, equations, state, 0.0, seconds, seconds / 100);
  } catch (const odeint::step_adjustment_error&) {
    state.fill(std::numeric_limits<double>::quiet_NaN());
  }
  return state;
}

template <class State, class Equations>
std::vector<Peer<State>> all(const Equations& equations, const State& start, double seconds) {
  std::vector<Peer<State>> list;
  const auto fixed = [&]<class Stepper>(const char* name, Stepper) {
    list.push_back({name, false, [=](double knob) {
                      State state = start;
                      odeint::integrate_n_steps(Stepper(), equations, state, 0.0, seconds / knob,
                                                static_cast<std::size_t>(knob));
                      return state;
                    }});
  };
  const auto controlled = [&]<class Stepper>(const char* name, Stepper) {
    list.push_back({name, true, [=](double knob) {
                      return adapted(odeint::make_controlled<Stepper>(knob, knob), equations, start,
                                     seconds);
                    }});
  };
  fixed("rk4", odeint::runge_kutta4<State>());
  fixed("Dormand-Prince 5", odeint::runge_kutta_dopri5<State>());
  fixed("Fehlberg 7(8)", odeint::runge_kutta_fehlberg78<State>());
  controlled("Dormand-Prince 5, controlled", odeint::runge_kutta_dopri5<State>());
  controlled("Fehlberg 7(8), controlled", odeint::runge_kutta_fehlberg78<State>());
  list.push_back({"Bulirsch-Stoer", true, [=](double knob) {
                    return adapted(odeint::bulirsch_stoer<State>(knob, knob), equations, start,
                                   seconds);
                  }});
  return list;
}

}  // namespace

std::vector<Peer<TopState>> odeint_on_top(const TopProblem& problem) {
  const auto& [torque, parameter, i, start, seconds] = problem;
  switch (torque) {
    case Torque::weight:
      return all(TopEquations<Torque::weight>{i, parameter}, start, seconds);
    case Torque::drive:
      return all(TopEquations<Torque::drive>{i, parameter}, start, seconds);
    case Torque::none:
      break;
  }
  return all(TopEquations<Torque::none>{i, parameter}, start, seconds);
}

std::vector<Peer<PointState>> odeint_on_point(Force force, const std::array<double, 2>& parameters,
                                              const PointState& start, double seconds) {
  const auto all_for = [&]<Force the_force>() {
    auto list = all(PointEquations<the_force>{parameters}, start, seconds);
    if constexpr (the_force != Force::gravity_and_drag)
      append_symplectic<the_force>(list, parameters, start, seconds);
    return list;
  };
  switch (force) {
    case Force::star:
      return all_for.template operator()<Force::star>();
    case Force::gravity_and_drag:
      return all_for.template operator()<Force::gravity_and_drag>();
    case Force::spring:
      break;
  }
  return all_for.template operator()<Force::spring>();
}

}  // namespace peers
