// By how much the limit of the step is too careful, in random nets of springs at rest.
#include <algorithm>
#include <support/random_generator.hpp>
#include <support/record.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

/// What a spring along n (unit, world axes), held at `arm` (body axes), does to a body: six numbers
/// in units of the root of the inverse mass and moments.
struct End {
  End(std::size_t which, const RigidBody<double>& body, const Vec3d& arm, const Vec3d& n)
      : index(which),
        push(std::sqrt(body.centre.inverse_mass) * n),
        turn(body.top.inverse_moments.cwiseSqrt().cwiseProduct(
            arm.cross(rotate_back<double>(body.top.orientation, n)))) {}
  std::size_t index;
  Vec3d push, turn;
};

struct Pull {
  double stiffness;
  std::vector<End> ends;  // one, or two
};

/// The square of the fastest swing, 1/s²: how many times as large a motion becomes, in the end,
/// when the springs answer it again and again.
double fastest_square(const std::vector<Pull>& pulls, std::size_t bodies,
                      support::RandomGenerator& dice) {
  std::vector<Vec3d> moves(2 * bodies), answers(2 * bodies);
  for (Vec3d& move : moves) move = dice.vector<double>();
  double times = 0;
  for (int n = 0; n < 2000; ++n) {
    double before = 0, after = 0;
    for (const Vec3d& move : moves) before += move.squaredNorm();
    std::fill(answers.begin(), answers.end(), Vec3d(0, 0, 0));
    for (const Pull& pull : pulls) {
      double stretch = 0;
      for (const End& end : pull.ends)
        stretch += end.push.dot(moves[2 * end.index]) + end.turn.dot(moves[2 * end.index + 1]);
      for (const End& end : pull.ends) {
        answers[2 * end.index] += pull.stiffness * stretch * end.push;
        answers[2 * end.index + 1] += pull.stiffness * stretch * end.turn;
      }
    }
    for (const Vec3d& answer : answers) after += answer.squaredNorm();
    times = std::sqrt(after / before);
    for (std::size_t k = 0; k < moves.size(); ++k) moves[k] = answers[k] / std::sqrt(after);
  }
  return times;
}

/// How many times the world's limit the true one is, of a net of one to six boxes and points: each
/// is held by a spring, and about every second pair is joined by another. They hold the boxes
/// within, or by arms of up to 1 m along each axis.
double too_careful(std::uint64_t seed, bool by_arms) {
  support::RandomGenerator dice(seed);
  World<double> world;
  world.on_warning([](const std::string&) {});
  std::vector<BodyHandle> handles;
  std::vector<RigidBody<double>> bodies;
  std::vector<Vec3d> sizes;
  std::vector<Pull> pulls;
  const auto arm_on = [&](std::size_t n) -> Vec3d {
    const Vec3d within = sizes[n].cwiseProduct(dice.vector<double>()) / 2;
    return by_arms && !sizes[n].isZero() ? dice.vector<double>() : within;
  };
  const auto place_of = [&](std::size_t n, const Vec3d& arm) -> Vec3d {
    return bodies[n].centre.position + rotate<double>(bodies[n].top.orientation, arm);
  };
  const auto spring_over = [&](const Vec3d& extent) -> Spring<double> {
    return {.stiffness = std::exp2(6 * dice.real<double>()), .rest_length = extent.norm()};
  };
  const std::size_t count = 1 + dice.below(6);
  for (std::size_t n = 0; n < count; ++n) {
    const double mass = std::exp2(4 * dice.real<double>());
    const Vec3d place = 5 * dice.vector<double>();
    const Vec3d sides = (Vec3d(1.1, 1.1, 1.1) + dice.vector<double>()) / 2;
    const bool is_point = dice.one_in(3);
    bodies.emplace_back();
    bodies[n].centre = make_particle<double>(mass, place);
    if (!is_point)
      bodies[n] =
          make_rigid_body<double>("box", mass_properties(Box<double>{sides}, mass), {place}).body;
    sizes.push_back(is_point
                        ? Vec3d(0, 0, 0)
                        : Vec3d(rotate_back<double>(bodies[n].top.orientation, sides).cwiseAbs()));
    handles.push_back(world.add("body " + std::to_string(n), bodies[n]));
    const Vec3d arm = arm_on(n), anchor = 5 * dice.vector<double>();
    const Vec3d extent = place_of(n, arm) - anchor;
    const Spring<double> spring = spring_over(extent);
    world.add(SpringToPoint<double>{spring, anchor, arm}, {handles[n]});
    pulls.push_back({spring.stiffness, {End(n, bodies[n], arm, extent.normalized())}});
    for (std::size_t m = 0; m < n; ++m) {
      if (!dice.one_in(2)) continue;
      const Vec3d first = arm_on(n), second = arm_on(m);
      const Vec3d between = place_of(n, first) - place_of(m, second);
      const Spring<double> joint = spring_over(between);
      world.add(SpringBetween<double>{joint, first, second}, {handles[n], handles[m]});
      pulls.push_back({joint.stiffness,
                       {End(n, bodies[n], first, between.normalized()),
                        End(m, bodies[m], second, -between.normalized())}});
    }
  }
  const double truth = 2 / std::sqrt(fastest_square(pulls, count, dice));
  return truth / world.step_limit().time_step;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("A thousand random nets: the true limit is so many times that of the world\n");
  std::printf("            at least   in half   in a fifth more than   at most\n");
  support::Table shares = notebook.table("careful", {"nets", "times the limit", "bear more (%)"});
  for (const bool by_arms : {false, true}) {
    std::vector<double> times;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) times.push_back(too_careful(seed, by_arms));
    std::sort(times.begin(), times.end());
    std::printf("%-10s %9.2f %9.2f %22.2f %9.2f\n", by_arms ? "by arms" : "held within", times[0],
                times[499], times[799], times[999]);
    const std::string name = by_arms ? "by_arms" : "within";
    for (std::size_t n = 0; n < 1000; n += n < 990 ? 10 : 1)
      shares.row(name, times[n], double(999 - n) / 10);
    notebook.value(name + "_fifth", support::number("%.1f", times[799]));
    notebook.value(name + "_most", support::number("%.1f", times[999]));
    support::expect(times[0] >= 1 - 1e-9, "no limit is too long");
  }
}
