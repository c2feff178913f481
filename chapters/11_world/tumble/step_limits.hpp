/// @file
/// Up to which time step springs, dampers, drag and controllers can't feed on themselves.
#pragma once

#include <string>
#include <tumble/responses.hpp>
#include <vector>

namespace tumble {

/// The bound of a scene, as its bodies are now: for small motions about an equilibrium.
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
/// Where stiffness and damping are in the same proportion everywhere, this is h² times the same of
/// k, plus 2 h times that of c. Elsewhere it is more. In a step t < 1 times as long each s is at
/// most t times as large, so the step that the same proportion would allow is shortened by as much.
///
/// All this is Euler's, and so Verlet's. Without dampers it comes down to w h < 2 for the fastest
/// swing, and Suzuki's scheme bears more. With dampers Euler's limit is taken for Suzuki's too:
/// that is tried on random scenes, and not proved.
//! [bound]
template <class Real, class Roster>
StepLimit<Real> step_limit(const Work<Real>& work, const Roster& roster) {
  const Responses<Real> responses(work.effects, roster);
  StepLimit<Real> limit = responses.limit();
  if (!responses.is_damped())
    limit.time_step *= static_cast<Real>(largest_stable_angle(work.scheme) / 2);
  return limit;
}
//! [bound]

/// Of which effects step_limit() knows nothing, though they may feed on themselves: a sentence
/// each.
//! [unknown_limits]
template <class Real>
std::vector<std::string> unknown_limits(const Work<Real>& work) {
  std::vector<std::string> sentences;
  for (const Entry<Real>& entry : work.effects)
    if (const EffectTraits<Real>& traits = entry.effect->traits();
        traits.may_feed_back && entry.visits.size() > 0)
      sentences.push_back(
          "'" + traits.name + "' reads " + text_of(traits.reads & quantity::of_motion) +
          (traits.finds_pairs ? ", of pairs that it finds itself" : ", and has no response()"));
  return sentences;
}
//! [unknown_limits]

}  // namespace tumble
