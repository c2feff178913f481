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
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 400, .rest_length = 3, .only_pulls = true},
                                .anchor = {0, 0, 10},
                                .attachment = {Real(0.1), 0, Real(0.1)}},
            {box});
  world.add(QuadraticDrag<Real>{.coefficient = Real(0.05)});
  return world;
}

template <class Real>
double booked(const Ledger<Real>& ledger, std::string_view name) {
  for (const LedgerLine& line : ledger.lines())
    if (line.name == name) return line.energy;
  return 0;
}

/// The books of the energy alone; table_of() has those of the momenta too.
void show_energy(const World<double>& world, const Ledger<double>& ledger) {
  const auto line = [](const std::string& name, double energy) {
    std::printf("%-23s %10.3g J\n", name.c_str(), energy);
  };
  line("at the start", ledger.start().energy);
  for (const LedgerLine& each : ledger.lines()) line("+ " + each.name, each.energy);
  line("now", ledger.now(world).energy);
  line("unexplained", ledger.rest(world).energy);
}

/// What the drag has taken, and by how much the sum of kinetic and stored energy has fallen: why
/// they differ.
void compare_with_stored(support::Notebook& notebook, const World<double>& world,
                         const Ledger<double>& ledger) {
  const double fall = ledger.start().energy + ledger.stored_at_start() - energy_of(world).sum();
  const double drag = -booked(ledger, "quadratic drag");
  // Booked are h F (v + v')/2 in a step, where the box falls by h v'. With the same F in all steps
  // the halves add up to the velocity at the end less that at the start.
  const auto& box = world.body(world.handle_at(0)).centre;
  const double weight = 9.81 * mass_of(box);
  const double worth = weight * (10 - box.position.z());
  const double gravity = booked(ledger, "gravity");
  const double half_kick = world.time_step() / 2 * weight * box.velocity.z();
  support::expect(std::abs(gravity - worth - half_kick) < 1e-10,
                  "gravity's books and the height differ by half a kick");
  support::expect(std::abs(drag - fall - half_kick) < 0.02 * half_kick,
                  "that is why the sum fell by less than the drag took");
  notebook.value("fall", support::number("%.2f J", fall));
  notebook.value("drag", support::number("%.2f J", drag));
  notebook.value("gravity", support::number("%.2f J", gravity));
  notebook.value("height", support::number("%.2f J", worth));
}

template <class Real>
double books(support::Notebook& notebook) {
  World<Real> world = thrown_box<Real>();
  //! [books]
  Ledger<Real> ledger(world);
  for (int n = 0; n < 600; ++n) ledger.step(world);
  //! [books]
  if constexpr (std::same_as<Real, double>) {
    show_energy(world, ledger);
    compare_with_stored(notebook, world, ledger);
  }
  return ledger.rest(world).energy;
}

/// What each effect has put in by each moment, and what the box has then.
void fill_accounts(support::Notebook& notebook) {
  World<double> world = thrown_box<double>();
  Ledger<double> ledger(world);
  support::Table table =
      notebook.table("accounts", {"time (s)", "gravity", "spring", "quadratic drag", "the box"});
  for (int n = 0; n <= 600; ++n) {
    if (n % 3 == 0)
      table.row(world.time(), booked(ledger, "gravity"), booked(ledger, "spring"),
                booked(ledger, "quadratic drag"), ledger.now(world).energy);
    ledger.step(world);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double rest = books<double>(notebook), rest_float = books<float>(notebook);
  std::printf("unexplained in float    %10.3g J\n", rest_float);
  support::expect(std::abs(rest) < 1e-9, "in double the books close to rounding");
  support::expect(std::abs(rest_float) > 1e3 * std::abs(rest), "a float rounds more");
  notebook.value("rest", support::number("%.1e J", rest));
  fill_accounts(notebook);
}
