#include <support/locked_motions.hpp>
#include <support/second_method.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Halves the step as check_orders() does. A motion about fewer axes may please a rung and fall
/// faster than it claims; or the leading terms of its error may cancel at one length of a step, so
/// that either the last halving or the mean of the last three shows the order.
template <class Forces>
void check_orders_reached(const Problem<Top<Wide>, Forces>& problem, const Top<Wide>& truth) {
  CAPTURE(problem.start.inverse_moments.template cast<float>().transpose());
  for (const auto& rung : torque_ladder<Wide, Forces>) {
    CAPTURE(std::string(rung.name));
    std::vector<Wide> errors;
    for (int steps = 4; steps <= (1 << 13); steps *= 2) {
      const Wide error = apart(after(problem, rung, steps), truth);
      if (error < 2e-15L) break;
      errors.push_back(error);
    }
    REQUIRE(errors.size() > 1);
    const auto order_of_last = [&](std::size_t halvings) {
      return std::log2(errors[errors.size() - 1 - halvings] / errors.back()) / Wide(halvings);
    };
    CHECK(std::max(order_of_last(1), order_of_last(std::min<std::size_t>(3, errors.size() - 1))) >
          rung.claims.order - 0.5L);
  }
}

}  // namespace

TEST_CASE(
    "Locked about one axis or two, under a weight, each rung of the torque ladder has its order") {
  for (const auto& locked : lockings) {
    Problem<Top<Wide>, CrookedWeight> problem{"", askew<Wide>(locked), {}, 2};
    const CrookedWeight& weight = problem.evaluate_forces;
    problem.start.angular_momentum_body = free_part<Wide>(problem.start, Vec3<Wide>(1, 2, 3));
    // What locks an axis adds to the change of L whatever keeps it at 0 there.
    const auto truth =
        integrated_top(problem.start, problem.seconds, 4000, [&](Top<Wide> now) -> Vec3<Wide> {
          now.orientation = normalized(now.orientation);
          weight(now, 0);
          const Vec3<Wide> torque = rotate_back(now.orientation, now.torque),
                           turning = gyroscopic_torque(now);
          return free_part<Wide>(now, torque + turning) - turning;
        });
    check_orders_reached(problem, truth);
  }
}

TEST_CASE("Turned by a motor about one line, each rung of the torque ladder has its order") {
  for (const auto& locked : lockings) {
    const auto problem = motored<Wide>(locked);
    check_orders_reached(problem, end_of(problem));
  }
}

TEST_CASE("As pendulums about each axis, each rung of the torque ladder has its order") {
  for (const int free : {0, 1, 2}) {
    const auto problem = pendulum<Wide>(free);
    check_orders_reached(problem, end_of(problem, free));
  }
}
