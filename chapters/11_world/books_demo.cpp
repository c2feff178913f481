// A box on a tether, thrown through air: who gave it its energy, and who took it.
#include <support/record.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/ledger.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>

using namespace tumble;

namespace {

/// The box as it is thrown, at the end of its tether.
template <class Real>
World<Real> thrown_box() {
  World<Real> world;
  const BodyHandle box = world.add(
      "box",
      make_rigid_body<Real>("box", mass_properties(Box<Real>{{Real(0.2), Real(0.3), Real(0.5)}}, 4),
                            {{3, 0, 10}}, {0, 4, 0}, {5, Real(0.1), 0})
          .body);
  world.add(Gravity<Real>{});
  world.add(
      SpringToPoint<Real>{
          .spring = {.stiffness = 400, .damping = 2, .rest_length = 3, .only_pulls = true},
          .anchor = {0, 0, 10},
          .attachment = {Real(0.1), 0, Real(0.1)}},
      {box});
  world.add(QuadraticDrag<Real>{.coefficient = Real(0.05)});
  return world;
}

template <class Real>
double books(bool print) {
  World<Real> world = thrown_box<Real>();
  //! [books]
  Ledger<Real> ledger(world);
  for (int n = 0; n < 600; ++n) ledger.step(world);
  //! [books]
  if (print) std::printf("%s\n", table_of(ledger, world).c_str());
  return ledger.rest(world).energy;
}

/// What each effect has put in by each moment, and what the box has then.
void fill_accounts(support::Notebook& notebook) {
  World<double> world = thrown_box<double>();
  Ledger<double> ledger(world);
  support::Table table =
      notebook.table("accounts", {"time (s)", "gravity", "spring", "quadratic drag", "the box"});
  for (int n = 0; n <= 600; ++n) {
    const auto energy_of = [&](std::string_view name) {
      for (const LedgerLine& line : ledger.lines())
        if (line.name == name) return line.energy;
      return 0.0;
    };
    if (n % 3 == 0)
      table.row(world.time(), energy_of("gravity"), energy_of("spring"),
                energy_of("quadratic drag"), ledger.now(world).energy);
    ledger.step(world);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double rest = books<double>(true), rest_float = books<float>(false);
  std::printf("unexplained in float: %.2g J\n", rest_float);
  support::expect(std::abs(rest) < 1e-9, "in double the books close to rounding");
  support::expect(std::abs(rest_float) > 1e3 * std::abs(rest), "a float rounds more");
  notebook.value("rest", support::number("%.1e J", rest));
  notebook.value("rest_float", support::number("%.1e J", rest_float));
  fill_accounts(notebook);
}
