// A spinning top under its weight: how it goes round, nods, sleeps and falls, and by which rules.
#include <numbers>
#include <support/record.hpp>
#include <support/recording.hpp>
#include <support/toy_gyroscope.hpp>

using namespace tumble;
using std::numbers::pi;
using support::number;

namespace {

const double degree = pi / 180, tilt = 60 * degree, spin = 200, seconds = 10;
const int steps_per_second = 240;
const double time_step = 1.0 / steps_per_second;
const Gyroscope<double> gyroscope = support::toy_gyroscope<double>();

void step(Topd& top) {
  support::step(top, gyroscope, drift<double>, time_step);
}

void show_numbers(support::Notebook& notebook) {
  const auto [slow, fast] = steady_precessions(gyroscope, std::cos(tilt), spin);
  const double rough = pull_of(gyroscope) / (gyroscope.along * spin);
  const auto exact = support::exactly_spinning(set_spinning(gyroscope, tilt, spin), gyroscope);
  const double nodding = 2 * pi / exact.nutation_period(),
               rough_nodding = gyroscope.along * spin / gyroscope.across;
  std::printf("I1 about the tip %.3e kg m^2, I3 %.3e kg m^2, M g l %.5f N m\n", gyroscope.across,
              gyroscope.along, pull_of(gyroscope));
  std::printf("round the vertical  %6.3f rad/s, roughly M g l/(I3 w3) = %.3f; the fast way %.1f\n",
              slow, rough, fast);
  std::printf("nods at             %6.2f rad/s, roughly I3 w3/I1 = %.2f\n", nodding, rough_nodding);
  const double lowest = std::acos(exact.lowest()), rough_dip = 2 * pull_of(gyroscope) *
                                                               gyroscope.across * std::sin(tilt) /
                                                               std::pow(gyroscope.along * spin, 2);
  std::printf("let go, it dips by  %6.2f deg, roughly %.2f\n", (lowest - tilt) / degree,
              rough_dip / degree);
  // How far the simple formulas are off, as fractions: those of precession, nodding and dip.
  const auto errors_at = [](double w) {
    const double momentum = gyroscope.along * w, pull = pull_of(gyroscope);
    const auto let_go = support::exactly_spinning(set_spinning(gyroscope, tilt, w), gyroscope);
    const double exactly_slow = steady_precessions(gyroscope, std::cos(tilt), w).first,
                 exactly_nodding = 2 * pi / let_go.nutation_period(),
                 exact_dip = std::acos(let_go.lowest()) - tilt;
    return std::array{
        pull / momentum / exactly_slow - 1, momentum / gyroscope.across / exactly_nodding - 1,
        2 * pull * gyroscope.across * std::sin(tilt) / (momentum * momentum) / exact_dip - 1};
  };
  const std::array errors = errors_at(spin), errors_at_twice = errors_at(2 * spin);
  const std::array names = {"error_left_precession", "error_left_nodding", "error_left_dip"};
  for (std::size_t k = 0; k < 3; ++k)
    notebook.value(names[k], number("%.0f %%", 100 * errors_at_twice[k] / errors[k]));
  const double sleeps = least_sleeping_spin(gyroscope);
  std::printf("stands by itself from %.1f rad/s on\n\n", sleeps);
  support::expect(std::abs(lowest_cosine(gyroscope, std::cos(tilt), spin) - exact.lowest()) < 1e-12,
                  "the dip is that of the elliptic solution");
  notebook.value("slow", number("%.2f rad/s", slow));
  notebook.value("rough", number("%.2f rad/s", rough));
  notebook.value("nodding", number("%.1f rad/s", nodding));
  notebook.value("rough_nodding", number("%.1f rad/s", rough_nodding));
  notebook.value("dip", number("%.1f°", (lowest - tilt) / degree));
  notebook.value("rough_dip", number("%.1f°", rough_dip / degree));
  notebook.value("sleeps", number("%.0f rad/s", sleeps));
  notebook.value("spin", number("%.0f rad/s", spin));
  notebook.value("turns_a_minute", number("%.0f", spin * 30 / pi));
  notebook.value("across", number("%.2e kg m²", gyroscope.across));
  notebook.value("along", number("%.2e kg m²", gyroscope.along));
}

/// Three ways to start: held still, pushed as it goes round steadily, and pushed the other way.
void follow_axis(const support::Notebook& notebook) {
  const double slow = steady_precessions(gyroscope, std::cos(tilt), spin).first;
  const auto at = [](const Topd& top) {
    return std::pair(support::azimuth_of(top) / degree, support::tilt_of(top) / degree);
  };
  support::Table exactly =
      notebook.table("path", {"let go, direction", "let go, tilt", "steady, direction",
                              "steady, tilt", "against, direction", "against, tilt"});
  support::Table stepped =
      notebook.table("path_stepped", {"let go, direction", "let go, tilt", "steady, direction",
                                      "steady, tilt", "against, direction", "against, tilt"});
  std::array<Topd, 3> tops = {set_spinning(gyroscope, tilt, spin),
                              set_spinning(gyroscope, tilt, spin, slow),
                              set_spinning(gyroscope, tilt, spin, -slow)};
  const std::array truths = {support::exactly_spinning(tops[0], gyroscope),
                             support::exactly_spinning(tops[1], gyroscope),
                             support::exactly_spinning(tops[2], gyroscope)};
  for (int n = 0; n <= 600; ++n) {
    const double time = n * 0.6 / 600;
    const auto [a, A] = at(truths[0].at(time));
    const auto [b, B] = at(truths[1].at(time));
    const auto [c, C] = at(truths[2].at(time));
    exactly.row(a, A, b, B, c, C);
  }
  for (int n = 0; n <= 0.6 * steps_per_second; ++n) {
    const auto [a, A] = at(tops[0]);
    const auto [b, B] = at(tops[1]);
    const auto [c, C] = at(tops[2]);
    if (n % 2 == 0) stepped.row(a, A, b, B, c, C);
    for (Topd& top : tops) step(top);
  }
}

/// L from above, every tenth of a second of a steady precession, and what the kicks between added.
void gather_kicks(const support::Notebook& notebook) {
  const double slow = steady_precessions(gyroscope, std::cos(tilt), spin).first;
  Topd top = set_spinning(gyroscope, tilt, spin, slow);
  support::Table table = notebook.table(
      "kicks", {"L x (g m^2/s)", "L y (g m^2/s)", "kicks x (g m^2/s)", "kicks y (g m^2/s)"});
  for (int n = 0; n < 13; ++n) {
    const Vec3d before = 1000 * angular_momentum_world(top);
    for (int k = 0; k < steps_per_second / 10; ++k) step(top);
    const Vec3d kicks = 1000 * angular_momentum_world(top) - before;
    table.row(before.x(), before.y(), kicks.x(), kicks.y());
  }
}

/// What each rule makes of the top, let go.
void try_rules(support::Notebook& notebook) {
  const Topd start = set_spinning(gyroscope, tilt, spin);
  const auto exact = support::exactly_spinning(start, gyroscope);
  support::Table tilts =
      notebook.table("keeps_up", {"time (s)", "exact", "steady", "explicit", "restored", "implicit",
                                  "carrying", "by axes", "with a sphere"});
  std::array<Topd, 7> tops;
  tops.fill(start);
  std::array<double, 7> turned{}, direction{}, least{}, most{}, falls{}, blows{};
  least.fill(tilt);
  most.fill(tilt);
  double exactly_turned = 0, exact_direction = 0;
  for (int n = 0; n <= seconds * steps_per_second; ++n) {
    const double time = n * time_step;
    const Topd truth = exact.at(time);
    std::array<double, 7> now{};
    for (std::size_t rule = 0; rule < 7; ++rule) {
      if (blows[rule] > 0) {
        now[rule] = NAN;
        continue;
      }
      now[rule] = support::tilt_of(tops[rule]);
      least[rule] = std::min(least[rule], now[rule]);
      most[rule] = std::max(most[rule], now[rule]);
      if (now[rule] > pi / 2 && falls[rule] == 0) falls[rule] = time;
      const double there = support::azimuth_of(tops[rule]);
      turned[rule] += std::remainder(there - direction[rule], 2 * pi);
      direction[rule] = there;
      support::step(tops[rule], gyroscope, support::rules<double>[rule].turn, time_step);
      if (!(kinetic_energy(tops[rule]) < 1000 * kinetic_energy(start))) blows[rule] = time;
    }
    const double there = support::azimuth_of(truth);
    exactly_turned += std::remainder(there - exact_direction, 2 * pi);
    exact_direction = there;
    if (time <= 2)
      tilts.row(time, support::tilt_of(truth) / degree, now[0] / degree, now[1] / degree,
                now[2] / degree, now[3] / degree, now[4] / degree, now[5] / degree,
                now[6] / degree);
  }
  std::printf("%d steps/s, %.0f s          tilt (deg)       round (rad/s)  below level\n",
              steps_per_second, seconds);
  std::printf("%-26s %6.1f to %5.1f %12.3f\n", "exact", std::acos(exact.highest()) / degree,
              std::acos(exact.lowest()) / degree, exactly_turned / seconds);
  for (std::size_t rule = 0; rule < 7; ++rule) {
    std::printf("%-26s %6.1f to %5.1f", support::rules<double>[rule].name, least[rule] / degree,
                most[rule] / degree);
    if (falls[rule] > 0)
      std::printf(" %12s  after %.2f s", "", falls[rule]);
    else
      std::printf(" %12.3f", turned[rule] / seconds);
    std::printf(blows[rule] > 0 ? ", gone after %.2f s\n" : "\n", blows[rule]);
  }
  const double round = exactly_turned / seconds, without = turned[0] / seconds;
  std::printf("\nM g l/(I1 w3), which the first rule follows: %.3f rad/s\n",
              pull_of(gyroscope) / (gyroscope.across * spin));
  notebook.value("round", number("%.2f rad/s", round));
  notebook.value("slower", number("%.1f", round / without));
  notebook.value("without_term", number("%.2f rad/s", without));
  notebook.value("explicit_gone", number("%.2f s", blows[1]));
  notebook.value("carrying_tilt", number("%.0f°", most[4] / degree));
  support::expect(std::abs(without * gyroscope.across * spin / pull_of(gyroscope) - 1) < 0.05,
                  "without the term the top goes round at M g l/(I1 w3)");
  const double steady_off = std::max(most[0] - tilt, tilt - least[0]) / degree;
  notebook.value("steady_off", number("%.2f", std::ceil(100 * steady_off) / 100));
  support::expect(steady_off < 1, "without the term it hardly nods");
  support::expect(blows[1] > 0 && falls[2] > 0 && falls[3] > 0,
                  "explicit, restored and implicit don't keep it up");
  support::expect(most[3] > 179 * degree, "the implicit rule ends hanging");
  support::expect(falls[4] == 0 && most[4] > 74 * degree, "carrying the momentum it sinks");
  for (const std::size_t rule : {std::size_t{5}, std::size_t{6}})
    support::expect(std::abs(turned[rule] / exactly_turned - 1) < 0.002 &&
                        std::abs(std::cos(most[rule]) - exact.lowest()) < 0.002,
                    "the splittings go round and dip as the exact top does");
}

/// How far the upright top, nudged, falls at most, against its spin.
void put_to_sleep(const support::Notebook& notebook) {
  support::Table table = notebook.table(
      "sleeping", {"spin (rad/s)", "largest tilt (degree)", "exact, without a nudge (degree)"});
  const double limit = least_sleeping_spin(gyroscope);
  for (int n = 0; n <= 32; ++n) {
    const double w = 5.0 * n;
    Topd top = set_spinning(gyroscope, 0, w);
    top.angular_momentum_body.x() = gyroscope.across * 1e-3;  // turned by a milliradian a second
    double most = 0;
    for (int k = 0; k < 20 * steps_per_second; ++k) {
      step(top);
      most = std::max(most, support::tilt_of(top));
    }
    const double ratio = w / limit,
                 lowest = ratio < 1 ? std::acos(2 * ratio * ratio - 1) / degree : 0;
    table.row(w, most / degree, lowest);
    if (ratio < 0.95)
      support::expect(std::abs(most / degree - lowest) < 2, "below the limit it falls as far");
    if (ratio > 1.05) support::expect(most / degree < 0.1, "above the limit it stands");
  }
}

/// The top let go, for the player to replay.
support::Recording recorded() {
  // Close enough for the drawn path to show the cusps, and for the wheel to be seen to turn
  // forwards.
  const int steps_per_frame = 3;
  support::Recording recording("A gyroscope, let go", time_step * steps_per_frame);
  const support::Part wheel =
      support::Part::cylinder(support::flywheel.radius, support::flywheel.height)
          .at(Posed{.position = {0, 0, support::flywheel_above_tip}, .orientation = {}});
  const double axle = 0.075, point = 0.01, stand = 0.075;
  const Quaterniond downwards{.real = 0, .imaginary = {1, 0, 0}};
  const support::Part shaft =
      support::Part::cylinder(0.002, axle - point)
          .at(Posed{.position = {0, 0, (axle + point) / 2}, .orientation = {}});
  const support::Part tip = support::Part::cone(0.002, point)
                                .at(Posed{.position = {0, 0, point}, .orientation = downwards});
  recording.add_body("gyroscope", {wheel, shaft, tip});
  recording.add_body(
      "stand",
      {support::Part::cone(0.015, stand).at(Posed{.position = {0, 0, -stand}, .orientation = {}})});
  recording.add_body("end of the axle", {support::Part::sphere(0.003)});
  Topd top = set_spinning(gyroscope, tilt, spin);
  for (int n = 0; n <= 2.8 * steps_per_second; ++n) {
    if (n % steps_per_frame == 0)
      recording.add_frame(
          std::array{Posed{.position = {0, 0, 0}, .orientation = top.orientation},
                     Posed{.position = {0, 0, 0}, .orientation = {}},
                     Posed{.position = axle * axis_of(top), .orientation = top.orientation}});
    step(top);
  }
  return recording;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  show_numbers(notebook);
  follow_axis(notebook);
  gather_kicks(notebook);
  try_rules(notebook);
  put_to_sleep(notebook);
  recorded().write(notebook.file_in_folder("gyroscope.recording.json"));
}
