/// @file
/// Pairs of Runge–Kutta–Nyström rules, for forces that depend on time and place alone.
#pragma once

#include <array>
#include <cstddef>

namespace tumble {

/// A rule for x'' = a(x, t). Stage i is evaluated nodes[i] h after the start, where the velocity
/// leads, displaced by h² Σ coefficients[i][j] a_j from the stages before it. The position gains
/// h² Σ places[j] a_j and the velocity h Σ velocities[j] a_j; the errors are weighed likewise. The
/// last stage is evaluated at the end of the step, and is the first of the next.
template <std::size_t s>
struct NystromTableau {
  std::array<long double, s> nodes;
  std::array<std::array<long double, s>, s> coefficients;
  std::array<long double, s> places, velocities, errors_of_places, errors_of_velocities;
};

/// Eighth order with a sixth beside it, nine stages of which eight are new: Dormand, El-Mikkawy and
/// Prince (1987).
struct DormandPrinceNystrom86 {
  static constexpr int power = 7;  ///< the estimated error of a step falls as h to this power
  static constexpr NystromTableau<9> rule = {
      .nodes = {0, 1 / 20.0L, 1 / 10.0L, 3 / 10.0L, 1 / 2.0L, 7 / 10.0L, 9 / 10.0L, 1, 1},
      .coefficients = {{{},
                        {1 / 800.0L},
                        {1 / 600.0L, 1 / 300.0L},
                        {9 / 200.0L, -9 / 100.0L, 9 / 100.0L},
                        {-66701 / 197352.0L, 28325 / 32892.0L, -2665 / 5482.0L, 2170 / 24669.0L},
                        {227015747 / 304251000.0L, -54897451 / 30425100.0L, 12942349 / 10141700.0L,
                         -9499 / 304251.0L, 539 / 9250.0L},
                        {-1131891597 / 901789000.0L, 41964921 / 12882700.0L, -6663147 / 3220675.0L,
                         270954 / 644135.0L, -108 / 5875.0L, 114 / 1645.0L},
                        {13836959 / 3667458.0L, -17731450 / 1833729.0L, 1063919505 / 156478208.0L,
                         -33213845 / 39119552.0L, 13335 / 28544.0L, -705 / 14272.0L,
                         1645 / 57088.0L},
                        {223 / 7938.0L, 0, 1175 / 8064.0L, 925 / 6048.0L, 41 / 448.0L,
                         925 / 14112.0L, 1175 / 72576.0L}}},
      .places = {223 / 7938.0L, 0, 1175 / 8064.0L, 925 / 6048.0L, 41 / 448.0L, 925 / 14112.0L,
                 1175 / 72576.0L},
      .velocities = {223 / 7938.0L, 0, 5875 / 36288.0L, 4625 / 21168.0L, 41 / 224.0L,
                     4625 / 21168.0L, 5875 / 36288.0L, 223 / 7938.0L},
      .errors_of_places = {223 / 7938.0L - 7987313 / 109941300.0L, 0,
                           1175 / 8064.0L - 1610737 / 44674560.0L,
                           925 / 6048.0L - 10023263 / 33505920.0L,
                           41 / 448.0L + 497221 / 12409600.0L,
                           925 / 14112.0L - 10023263 / 78180480.0L,
                           1175 / 72576.0L - 1610737 / 402071040.0L},
      .errors_of_velocities = {
          223 / 7938.0L - 7987313 / 109941300.0L, 0, 5875 / 36288.0L - 1610737 / 40207104.0L,
          4625 / 21168.0L - 10023263 / 23454144.0L, 41 / 224.0L + 497221 / 6204800.0L,
          4625 / 21168.0L - 10023263 / 23454144.0L, 5875 / 36288.0L - 1610737 / 40207104.0L,
          223 / 7938.0L + 4251941 / 54970650.0L, -3 / 20.0L}};
};

}  // namespace tumble
