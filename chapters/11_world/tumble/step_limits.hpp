/// @file
/// Up to which time step springs, dampers, drag and controllers can't feed on themselves.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <tumble/responses.hpp>
#include <vector>

namespace tumble {

/// The bound of a scene, as its bodies are now: for small motions about an equilibrium. It is
/// proved for Euler's scheme and Verlet's, and tried for Scheme::suzuki; infinite if nothing limits
/// the step.
///
/// What holds a body in several places is stiffer there. By chapter 6's limit nothing grows while
/// all holds, each of the strength s = h² k + 2 h c, pull back by less than 4 in every direction of
/// motion, in units of the inverse mass. The strongest pull is the largest Σ |Σ √s b x|², summed
/// over the bodies, where b is what a hold does to the body at its end, √w long at most with the
/// inverse mass w there, and the squares of the x, one for each hold, sum to 1. By Cauchy and
/// Schwarz |Σ √s b x|² ≤ Σ √s · Σ √s w x². So no pull exceeds the largest √s (w_a Σ_a √s + w_b Σ_b
/// √s) of a hold, with the sums over the holds at either of its ends. Across its direction a
/// stretched spring resists less than along it, by (l − l₀)/l, and a compressed one pushes aside;
/// so its k stands for all directions.
///
/// A force at an arm also resists turns by what it is, see turning_stiffness(). Those of one body
/// add up to a matrix, and h² times the largest of its eigenvalues in units of the inverse moments,
/// among all bodies, is added to the pull: of a sum of two symmetric matrices no eigenvalue exceeds
/// the sum of the largest.
///
/// So are the turning stiffness K and the turning damping C of an effect, a controller say: h²
/// times the largest eigenvalue of K in these units, and 2 h times that of C. An effect that
/// answers the turn of one body relative to another has K in both, and −K between. In no motion
/// does that pull harder than 2 K in each alone.
///
/// None of this asks that stiffness and damping share their axes. Take all coordinates in units of
/// the root of the inverse inertia. Let d be their change in a step, d' that in the step before and
/// m the mean of where the step begins and ends. Then V = d·S d + m·h² K m, where S = 1 − h² K/4 −
/// h C/2, falls in each step by (d + d')·h C (d + d')/2. It is a sum of squares as long as h² K +
/// 2 h C < 4, and so nothing grows. Where that is 4 along a motion, a step multiplies it by −1.
///
/// A spin adds to this. Let a top spin steadily about its axis, and let q be what its axis is
/// tilted by, in the same units. Between two kicks the velocity v of q circles with the nutation,
/// by the angle θ in a step: see nutation_rate(). As a matrix, let Z be the turn of v by θ/2 twice
/// over, so that a drift leaves e^Z v, and leads by d = (e^Z − 1)/Z h v. Since Z/(e^Z − 1) is N −
/// Z/2, where N is θ/2 cot θ/2, a kick reads
///
///     (N − Z/2) d = (N + Z/2) d' − h² K q,
///
/// with d' for the step before. Multiply by d + d'. What has Z in it drops out, since Z turns by a
/// right angle, and V = d·(N − h² K/4) d + m·h² K m stays what it was. It is a sum of squares as
/// long as h² K < 4 N: the old condition, with every inverse moment multiplied by 1/N, see
/// yielding(), and each nutation below half a turn in a step. Along a motion where the two are
/// equal a step multiplies by −1. Nothing asks for parallel axes or equal spins; what grows at all
/// is a free flight that no force resists.
///
/// The same in one line, and somewhat stricter: as N is at least 1 − (θ/π)², a step h is short
/// enough if 1/h² ≥ 1/h₀² + (ν/π)², with the limit h₀ of the scene at rest and its fastest nutation
/// ν.
///
/// A rotor adds to it, as it holds at `time` (s). Along the axis of a symmetric top its half turns
/// leave the axis and Π = L + H alone, and between them the top is free: the axis circles by θ = h
/// |Π|/I⊥, and all is as before with Π for L. Elsewhere Π is put for L too. Beside one locked axis
/// the spin turns about it by a midpoint rule, Z = h A there: N is 1, and nothing is lost.
///
/// This is proved for tops that spin about an axis of symmetry between springs that hold that axis,
/// without dampers, or with dampers that act alike on all of these motions. For other bodies,
/// whose stiffness or inertia turns past, even the true motion may grow in some of them, and with
/// it every step, however short. Dampers that act in single directions of a spinning body let some
/// motion grow in any step, by a part that falls about as h⁴.
///
/// Where stiffness and damping are in the same proportion everywhere, this is h² times the same of
/// k, plus 2 h times that of c. Elsewhere it is more. In a step t < 1 times as long each s is at
/// most t times as large, so the step that the same proportion would allow is shortened by as much.
///
/// All this is Euler's, and so Verlet's. Without dampers it comes down to w h < 2 for the fastest
/// swing, and Scheme::suzuki bears a longer step: that much longer at rest, and 1/(1 − 1.5 (θ/π)²)
/// in place of 1/N where that allows more than Euler's. With dampers Euler's limit is taken for
/// Suzuki's too. Both are tried on random scenes, and not proved.
//! [bound]
template <class Real>
StepLimit<Real> step_limit(const StepPlan<Real>& plan, const NamedBodies<Real>& bodies,
                           Same<Real> time) {
  const Responses<Real> responses(plan, bodies, time);
  const Real half_turn = std::numbers::pi_v<Real>;
  const StepLimit<Real> limit = responses.limit(1, half_turn, yielding<Real>);
  if (responses.is_damped() || plan.scheme != Scheme::suzuki) return limit;
  const StepLimit<Real> suzuki =
      responses.limit(static_cast<Real>(largest_stable_angle(plan.scheme) / 2),
                      half_turn / std::sqrt(Real(1.5)), [half_turn](Real angle) {
                        return 1 / (1 - Real(1.5) * (angle / half_turn) * (angle / half_turn));
                      });
  return suzuki.time_step > limit.time_step ? suzuki : limit;
}
//! [bound]

/// What may go wrong in the step at `at`, such as one that is too long for a spring: a sentence, or
/// none.
template <class Real>
std::vector<std::string> warnings(const StepPlan<Real>& plan, const NamedBodies<Real>& bodies,
                                  const StepTime<Real>& at) {
  const StepLimit<Real> limit = step_limit(plan, bodies, at.time);
  if (at.time_step <= limit.time_step) return {};
  const auto named = [&](BodyIndex body) { return "'" + bodies.registry.name_of(body) + "'"; };
  std::string warning = "'" + plan.effects[limit.effect].effect->name() + "' on " +
                        named(limit.body) + " may gain energy without bound: the time step is " +
                        text_of(at.time_step) + " s, and only up to " + text_of(limit.time_step) +
                        " s can this be excluded";
  if (at.time_step <= limit.at_rest) {
    const BodyIndex body = limit.spinning;
    const Vec3<Real> rotors =
        nutating_momentum(plan, bodies.top_of(body), bodies.body(body).top, at.time);
    warning +=
        ", since " +
        (rotors == Vec3<Real>::Zero() ? named(body) + " spins"
                                      : "a wheel spins in " + named(body)) +
        ", and its nutation turns by " +
        text_of(std::round(at.time_step * limit.nutation_rate * 180 / std::numbers::pi_v<Real>)) +
        " degrees in a step";
  }
  return {warning};
}

/// Of which effects step_limit() knows nothing, though they may feed on themselves: a sentence
/// each.
template <class Real>
std::vector<std::string> unknown_limits(const StepPlan<Real>& plan) {
  std::vector<std::string> sentences;
  for (const EffectInstance<Real>& instance : plan.effects)
    if (const EffectTraits<Real>& traits = instance.effect->traits();
        traits.may_feed_back && instance.members.size() > 0)
      sentences.push_back(
          "'" + traits.name + "' reads " + text_of(traits.reads & quantity::of_motion) +
          (traits.finds_pairs ? ", of pairs that it finds itself" : ", and has no response()"));
  return sentences;
}

}  // namespace tumble
