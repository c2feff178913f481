// Steps that choose themselves, for smaller and smaller tolerances along an eccentric orbit.
#include <support/exact_motion.hpp>
#include <support/problems.hpp>
#include <support/record.hpp>
#include <tumble/embedded_steps.hpp>
#include <tumble/nystrom_steps.hpp>

using namespace tumble;
using namespace tumble::support;

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  const auto orbit = eccentric_orbit<double>();
  std::printf("%-10s %21s %21s %21s\n%-10s", "orbit", "5(4)", "8(5,3)", "Nystrom 8(6)",
              "tolerance");
  for (int n = 0; n < 3; ++n) std::printf("%6s %6s %7s", "steps", "again", "error");
  std::puts("");
  Table counted = notebook.table("own_steps_tolerance",
                                 {"tolerance", "pair 5(4)", "pair 8(5,3)", "Nyström 8(6)"});
  const Particled there = exactly_after(orbit.evaluate_forces, orbit.start, orbit.seconds);
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    std::printf("%-10.0e", tolerance);
    const auto go = [&](auto by) {
      Particled particle = orbit.start;
      const StepCounts counts = by(particle);
      std::printf("%6ld %6ld %7.0e", counts.steps, counts.rejected,
                  (particle.position - there.position).norm());
      return static_cast<double>(counts.steps);
    };
    const double fifth = go([&](Particled& p) {
      return integrate<DormandPrince54>(p, orbit.evaluate_forces, 0.0, orbit.seconds,
                                        {tolerance, tolerance});
    });
    const double eighth = go([&](Particled& p) {
      return integrate<DormandPrince853>(p, orbit.evaluate_forces, 0.0, orbit.seconds,
                                         {tolerance, tolerance});
    });
    const double nystrom = go([&](Particled& p) {
      return integrate_by_nystrom<DormandPrinceNystrom86>(p, orbit.evaluate_forces, 0.0,
                                                          orbit.seconds, {tolerance, tolerance});
    });
    std::puts("");
    expect(tolerance > 1e-5 || (eighth < nystrom && nystrom < fifth),
           "for small tolerances the pair 8(5,3) takes the fewest steps");
    counted.row(tolerance, fifth, eighth, nystrom);
  }
}
