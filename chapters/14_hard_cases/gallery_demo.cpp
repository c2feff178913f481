// Hard cases going wrong in a naive way, and going right.
#include <support/record.hpp>
#include <support/recording.hpp>
#include <support/rules.hpp>
#include <tumble/far_from_origin.hpp>
#include <tumble/linearly_implicit.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Turn = void (*)(Topd&, double);

/// The energy against that at the start, at each step, by several rules.
void energies(const Notebook& notebook, const char* name, const TumblingProblem& problem) {
  const std::array<Turn, 5> rules = {
      turn_restoring_momentum<double>, turn_linearly_implicitly<double>,
      turn_carrying_momentum<double>, turn_axis_by_axis<double>, turn_by_splitting<double>};
  std::array<Topd, 5> tops;
  tops.fill(top_of<double>(problem));
  const double start = kinetic_energy(tops[0]);
  Table table =
      notebook.table(name, {"time (s)", "restored", "linear", "carried", "by axes", "ours"});
  for (int n = 0; n <= 300; ++n) {
    std::array<double, 5> energy;
    for (std::size_t rule = 0; rule < 5; ++rule) {
      energy[rule] = kinetic_energy(tops[rule]) / start;
      rules[rule](tops[rule], 1.0 / 60);
    }
    table.row(n / 60.0, energy[0], energy[1], energy[2], energy[3], energy[4]);
  }
}

/// A flat plate with the moments of problem B, spinning about its stable axis, as it is drawn from
/// the third minute on.
Recording plate_after_minutes(const char* title, Turn turn) {
  Recording recording(title, 1.0 / 30);
  // Moments of 1, 2 and 3 belong to a plate without thickness: sides as the roots of 4 and 2.
  recording.add_body("plate", {Part::box({2 * 0.5, std::sqrt(2) * 0.5, 0.03})});
  const std::array<int, 3> as_drawn = {0, 1, 2};
  Topd top = top_in_order<double>(tumbling_problems[1], as_drawn);
  for (int n = 0; n < 60 * 180; ++n) turn(top, 1.0 / 60);
  for (int n = 0; n <= 60 * 10; ++n) {
    if (n % 2 == 0) recording.add_frame(std::array{Posed{Vec3d::Zero(), top.orientation}});
    turn(top, 1.0 / 60);
  }
  return recording;
}

/// Forty beads on springs. In one step, one of them is given a force that is not a number.
int beads_lost(std::vector<Particlef>& beads, float stiffness, float time_step) {
  for (std::size_t n = 0; n + 1 < beads.size(); ++n) {
    const Vec3f pull = stiffness * (beads[n + 1].position - beads[n].position - Vec3f(1, 0, 0));
    beads[n].force += pull;
    beads[n + 1].force -= pull;
  }
  int lost = 0;
  for (Particlef& bead : beads) {
    step(bead, time_step);
    clear_force(bead);
    lost += !is_finite(bead.position);
  }
  return lost;
}

/// The same beads in a world, one with a motor that breaks.
struct BrokenMotor {
  static constexpr std::string_view name = "motor";
  Vec3f force(const Particlef&, float time) const {
    return {time < 0.15f ? 0 : std::numeric_limits<float>::quiet_NaN(), 0, 0};
  }
};

void chain(Notebook& notebook) {
  const float stiffness = 100, h = 1.0f / 60;
  std::vector<Particlef> beads;
  World<float> world(steps_per_second(60));
  std::vector<BodyHandle> handles;
  for (int n = 0; n < 40; ++n) {
    beads.push_back(make_particle(1.0f, Vec3f(float(n), 0, 0)));
    handles.push_back(world.add("bead " + std::to_string(n), beads.back()));
  }
  std::vector<BodyHandle> pairs;
  for (std::size_t n = 0; n + 1 < handles.size(); ++n)
    pairs.insert(pairs.end(), {handles[n], handles[n + 1]});
  world.add(SpringBetween<float>{.spring = {.stiffness = stiffness, .rest_length = 1}}, pairs);
  world.add(BrokenMotor{}, {handles[20]});

  Table table = notebook.table("chain", {"step", "naive", "ours"});
  std::string sentence;
  int lost = 0;
  for (int n = 1; n <= 40; ++n) {
    if (n == 10) add_force(beads[20], Vec3f(0, 0, 0)), beads[20].force.x() = std::nanf("");
    lost = beads_lost(beads, stiffness, h);
    int lost_of_ours = 0;
    try {
      world.step();
    } catch (const SimulationError& error) {
      sentence = error.what();
    }
    for (const BodyHandle handle : handles) lost_of_ours += !is_finite(world.position(handle));
    expect(lost_of_ours == 0, "the world loses nobody");
    table.row(double(n), double(lost), double(lost_of_ours));
  }
  expect(lost == 40, "one NaN reaches every bead");
  notebook.value("stopped", sentence);
}

/// How far a particle in float gets that should go at a steady speed, far from the origin.
void far_away(Notebook& notebook) {
  const float h = 1.0f / 60, speed = 1;
  const std::array<float, 4> places = {10e3f, 300e3f, 900e3f, 1200e3f};
  std::array<Particlef, 4> particles;
  for (std::size_t n = 0; n < 4; ++n)
    particles[n] = make_particle(1.0f, Vec3f(places[n], 0, 0), Vec3f(speed, 0, 0));
  Table table = notebook.table("far_away", {"time (s)", "10 km", "300 km", "900 km", "1200 km"});
  for (int n = 0; n <= 120; ++n) {
    std::array<double, 4> gone;
    for (std::size_t k = 0; k < 4; ++k) {
      gone[k] = double(particles[k].position.x()) - double(places[k]);
      drift(particles[k], h);
    }
    table.row(n / 60.0, gone[0], gone[1], gone[2], gone[3]);
  }
  std::printf("In float, at 60 steps a second:\n    distance      spacing   slowest speed\n");
  for (const float place : {1.0f, 1e3f, 10e3f, 100e3f, 1e6f, 10e6f})
    std::printf("%9.0f m  %9.2g m  %9.2g m/s\n", double(place), double(spacing_at(place)),
                double(slowest_drift_at(place, h)));
  expect(particles[3].position.x() == places[3], "beyond a certain place nothing moves");
  notebook.value("digits_km", std::to_string(digits_needed(1e3, 1e-3)));
  notebook.value("digits_earth", std::to_string(digits_needed(1e7, 1e-3)));
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  energies(notebook, "rod", tumbling_problems[2]);
  energies(notebook, "needle", tumbling_problems[3]);
  chain(notebook);
  far_away(notebook);
  plate_after_minutes("A", turn_restoring_momentum<double>)
      .write(notebook.file_in_folder("plate_restored.recording.json"));
  plate_after_minutes("B", turn_by_splitting<double>)
      .write(notebook.file_in_folder("plate.recording.json"));
}
