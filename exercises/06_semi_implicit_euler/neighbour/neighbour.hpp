/// @file
/// Exercise: the energy that kick and drift does keep.
#pragma once

#include <exercise/todo.hpp>

/// The energy, in J, that a step of kick and drift keeps up to a term in h³: `energy` and what
/// the terms in h and h² add to it. The particle of `mass` kg moves on a line at `velocity` m/s;
/// where it is, the force is `force` N and grows by `slope` N per metre; a step takes `time_step` s
/// (h).
template <class Real>
Real neighbours_energy(Real energy, Real force, Real slope, Real velocity, Real mass,
                       Real time_step) {
  todo("the energy, with its terms in h and h²");
}
