// A weight on a spring, stepped in both orders: its path in the plane of place and velocity, its
// energy, and what a step does to a patch of that plane.
#include <support/record.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using tumble::support::number;

namespace {

const double frequency = 1;  // ω, rad/s: one swing takes 2π seconds
const double pi = 3.14159265358979323846;

void gather_spring(Particled& weight) {
  clear_force(weight);
  add_force(weight, -frequency * frequency * weight.position);
}

double energy(const Particled& weight) {
  return (weight.velocity.squaredNorm() + frequency * frequency * weight.position.squaredNorm()) /
         2;
}

void draw_phase_portrait(const support::Notebook& notebook) {
  const double time_step = 0.3;
  Particled semi = make_particle(1.0, Vec3d(1, 0, 0)), explicitly = semi;
  support::Table table =
      notebook.table("phase_portrait", {"time (s)", "explicit x (m)", "explicit v (m/s)",
                                        "semi-implicit x (m)", "semi-implicit v (m/s)"});
  for (int n = 0; n <= 42; ++n) {
    if (n <= 26)
      table.row(n * time_step, explicitly.position.x(), explicitly.velocity.x(), semi.position.x(),
                semi.velocity.x());
    else
      table.row(n * time_step, "", "", semi.position.x(), semi.velocity.x());
    gather_spring(semi);
    gather_spring(explicitly);
    step(semi, time_step);
    explicit_step(explicitly, time_step);
  }
}

/// A square patch of starts, kicked and drifted; beside it the same patch after an explicit step.
void draw_patch(const support::Notebook& notebook) {
  const double time_step = 0.6;
  support::Table table = notebook.table("patch", {"patch", "x (m)", "v (m/s)"});
  support::Table areas = notebook.table("patch_areas", {"patch", "area (m²/s)"});
  const auto outline = [&](const char* name, auto move) {
    double area = 0, last_x = 0, last_v = 0;  // half the sum of the cross products, once around
    for (const auto& [x, v] :
         {std::pair{0.8, -0.2}, {1.2, -0.2}, {1.2, 0.2}, {0.8, 0.2}, {0.8, -0.2}}) {
      Particled corner = make_particle(1.0, Vec3d(x, 0, 0), Vec3d(v, 0, 0));
      gather_spring(corner);
      move(corner);
      const double now_x = corner.position.x(), now_v = corner.velocity.x();
      table.row(name, now_x, now_v);
      area += (last_x * now_v - now_x * last_v) / 2;
      last_x = now_x, last_v = now_v;
    }
    areas.row(name, area);
    return area;
  };
  const double start = outline("start", [](Particled&) {});
  outline("kicked", [=](Particled& corner) { kick(corner, time_step); });
  const double stepped = outline("stepped", [=](Particled& corner) { step(corner, time_step); });
  outline("explicit", [=](Particled& corner) { explicit_step(corner, time_step); });
  support::expect(std::abs(stepped / start - 1) < 1e-14, "a step keeps the area");
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  draw_phase_portrait(notebook);
  draw_patch(notebook);

  //! [both]
  const double time_step = checked_time_step(0.05);
  Particled semi = make_particle(1.0, Vec3d(1, 0, 0)), explicitly = semi;
  const auto swing_once_more = [&] {
    for (int n = 0; n < 126; ++n) {  // 126 steps of 0.05 s: one swing and a little
      gather_spring(semi);
      step(semi, time_step);
      gather_spring(explicitly);
      explicit_step(explicitly, time_step);
    }
  };
  //! [both]
  std::printf("energy after     explicit Euler   semi-implicit Euler   exact\n");
  for (int swings = 0; swings <= 64; ++swings) {
    const bool power_of_two = (swings & (swings - 1)) == 0;
    if (power_of_two)
      std::printf("%3d swings %17.5g J %19.5f J   %5.1f J\n", swings, energy(explicitly),
                  energy(semi), 0.5);
    if (swings < 64) swing_once_more();
  }
  double largest = 0;
  Particled again = make_particle(1.0, Vec3d(1, 0, 0));
  for (int n = 0; n < 64 * 126; ++n) {
    gather_spring(again);
    step(again, time_step);
    largest = std::max(largest, std::abs(energy(again) / 0.5 - 1));
  }
  notebook.value("explicit_energy", number("%.1e J", energy(explicitly)));
  notebook.value("largest_swing", number("%.1f %%", 100 * largest));
  const double half = frequency * time_step / 2;
  const double bound = half / (1 - half);
  support::expect(largest <= bound * (1 + 1e-9) && largest >= bound * (1 - 1e-3),
                  "the energy of kick and drift rises by (ωh/2)/(1 − ωh/2)");
  support::expect(energy(explicitly) > 1e6, "explicit Euler's energy has grown a million times");

  support::Table energies = notebook.table(
      "energy", {"swings", "explicit Euler (J)", "semi-implicit Euler (J)", "exact (J)"});
  Particled slow = make_particle(1.0, Vec3d(1, 0, 0)), fast = slow;
  for (int n = 0; n * 0.1 <= 5 * 2 * pi; ++n) {
    energies.row(n * 0.1 / (2 * pi), energy(fast), energy(slow), 0.5);
    gather_spring(slow);
    gather_spring(fast);
    step(slow, 0.1);
    explicit_step(fast, 0.1);
  }
}
