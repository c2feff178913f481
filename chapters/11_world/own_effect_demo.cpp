// An effect that Tumble has never heard of.
#include <support/record.hpp>
#include <tumble/gravity.hpp>
#include <tumble/world.hpp>

using namespace tumble;

//! [breeze]
/// A breeze that comes and goes, and meets only what lies above the hedge.
template <class Real>
struct Breeze {
  static constexpr std::string_view name = "breeze";
  Real strength = Real(0.5);  // N
  Real hedge = 2;             // m

  Vec3<Real> force(const Particle<Real>& centre, Real time) const {
    const Real blows = select(centre.position.z() > hedge, strength, Real(0));
    return {blows * std::sin(time), 0, 0};
  }
};
//! [breeze]

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [use]
  World<double> garden;
  const BodyHandle leaf = garden.add("leaf", make_particle<double>(0.01, {0, 0, 10}));
  garden.add("hedge", make_static_particle<double>({0, 0, 1}));
  garden.add(Gravity<double>{});
  garden.add(Breeze<double>{});
  for (int n = 0; n < 60; ++n) garden.step();
  //! [use]
  for (const PlanRow& row : garden.plan().rows)
    if (row.effect == "breeze")
      std::printf("%s visits %zu of %zu bodies; %s\n", row.effect.c_str(), row.visited, row.of,
                  row.reason.c_str());
  std::printf("after %g s the leaf is at %s m\n", garden.time(),
              text_of(garden.position(leaf)).c_str());
  support::expect(garden.position(leaf).x() > 1, "the breeze has moved the leaf");
}
