/// @file
/// The energy of a world, by kinds.
#pragma once

#include <tumble/world.hpp>

namespace tumble {

/// What a world has, J. What its effects store counts where they know it, as gravity and springs
/// do; of a reaction wheel's own motion nothing is counted.
struct WorldEnergy {
  double motion = 0;   ///< of the centres of mass, ½ m v²
  double turning = 0;  ///< about them, ½ ω·L
  double stored = 0;   ///< in the effects
  /// What stays the same as long as nothing gives or takes energy.
  double sum() const { return motion + turning + stored; }
};

/// The energy (J) stored in all effects that have a potential_energy(), in those bodies or pairs
/// that each visits. Of an effect that finds its pairs itself nothing is counted.
template <class Real, class Backend>
double stored_energy(const World<Real, Backend>& world) {
  const Bodies<Real>& bodies = world.bodies();
  double sum = 0;
  for (const EffectInstance<Real>& instance : world.effects()) {
    const EffectTraits<Real>& traits = instance.effect->traits();
    if (!traits.stores_energy || traits.finds_pairs) continue;
    const auto add = [&](BodyIndex first, BodyIndex second) {
      sum += static_cast<double>(
          instance.effect->potential_energy(state_of(bodies, first), state_of(bodies, second)));
    };
    for (const BodyIndex i : instance.members.indices) {
      const BodyIndex body = traits.visits_tops() ? bodies.body_of[i] : i;
      add(body, body);
    }
    for (const BodyPair& pair : instance.members.pairs) add(pair.first, pair.second);
  }
  return sum;
}

/// What the world has now. A static body has no kinetic energy, whatever velocity it was given.
template <class Real, class Backend>
WorldEnergy energy_of(const World<Real, Backend>& world) {
  const Bodies<Real>& bodies = world.bodies();
  WorldEnergy energy{.stored = stored_energy(world)};
  for (const Particle<Real>& centre : bodies.centres)
    energy.motion += static_cast<double>(kinetic_energy(centre));
  for (const Top<Real>& top : bodies.tops)
    energy.turning += static_cast<double>(kinetic_energy(top));
  return energy;
}

}  // namespace tumble
