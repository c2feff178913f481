// The sphere of L with the curves of constant energy, a stepped motion on it, and how long a flip
// makes one wait.
#include <array>
#include <numbers>
#include <support/polhodes.hpp>
#include <support/record.hpp>
#include <support/rules.hpp>

using namespace tumble;
using std::numbers::pi;
using support::number;

namespace {

const double degree = pi / 180, spin = 10;

/// The T-handle's axes from the smallest moment to the largest: about the bar, the shaft, the
/// third.
struct Handle {
  Topd top = support::thrown_t_handle().body.top;
  std::array<int, 3> axis = {0, 1, 2};

  Handle() {
    std::sort(axis.begin(), axis.end(),
              [&](int a, int b) { return top.inverse_moments[a] > top.inverse_moments[b]; });
  }
  Vec3d in_order(const Vec3d& v) const { return {v[axis[0]], v[axis[1]], v[axis[2]]}; }

  /// Thrown with a spin about the shaft, and `wobble` times as much about the bar.
  Topd thrown(double wobble) const {
    Vec3d w = Vec3d::Zero();
    w[axis[0]] = wobble * spin;
    w[axis[1]] = spin;
    Topd start = top;
    set_angular_velocity_body(start, w);
    return start;
  }
};

/// A picture of the sphere from one side: right, up, and towards the eye.
struct View {
  Vec3d eye = Vec3d(std::sin(38 * degree) * std::cos(22 * degree),
                    std::cos(38 * degree) * std::cos(22 * degree), std::sin(22 * degree));
  Vec3d right = Vec3d::UnitZ().cross(eye).normalized(), up = eye.cross(right);

  /// One line of the table for each point: where it is seen, in one pair of columns in front and in
  /// another at the back. No number breaks the line.
  void draw(support::Table& table, const std::vector<Vec3d>& line) const {
    for (const Vec3d& point : line) {
      const double x = right.dot(point), y = up.dot(point);
      if (eye.dot(point) >= 0)
        table.row(x, y, NAN, NAN);
      else
        table.row(NAN, NAN, x, y);
    }
    table.row(NAN, NAN, NAN, NAN);
  }
};

void draw_sphere(support::Notebook& notebook, const Handle& handle) {
  const View view;
  const auto open = [&](const char* name) {
    return notebook.table(name, {"front x", "front y", "back x", "back y"});
  };
  const Vec3d inverse = handle.in_order(handle.top.inverse_moments);
  support::Table curves = open("polhodes");
  for (const int around : {0, 2})
    for (const double off : {12.0, 26.0, 40.0}) {
      // The loop through the point so many degrees from its axis, towards the middle one.
      const double c = std::cos(off * degree), s = std::sin(off * degree);
      const double level = inverse[around] * c * c + inverse[1] * s * s;
      auto loop = support::polhode(inverse, level, around, 200);
      view.draw(curves, loop);
      for (Vec3d& point : loop) point = -point;
      view.draw(curves, loop);
    }
  support::Table border = open("separatrix");
  for (const double sign : {1.0, -1.0}) view.draw(border, support::separatrix(inverse, sign, 200));
  std::vector<Vec3d> rim;
  for (int n = 0; n <= 120; ++n)
    rim.push_back(std::cos(n * pi / 60) * view.right + std::sin(n * pi / 60) * view.up);
  support::Table outline = notebook.table("sphere", {"x", "y"});
  for (const Vec3d& point : rim) outline.row(view.right.dot(point), view.up.dot(point));
  support::Table ends = notebook.table("axes", {"x", "y", "name"});
  const std::array names = {"1", "2", "3"};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d end = Vec3d::Unit(axis);
    ends.row(view.right.dot(end), view.up.dot(end), names[static_cast<std::size_t>(axis)]);
  }

  // A throw with as much spin about the bar as three fifths of that about the shaft, stepped; and
  // the loop through its start.
  Topd top = handle.thrown(0.6);
  const double size = top.angular_momentum_body.norm();
  const double level = 2 * kinetic_energy(top) / (size * size);
  support::Table points = open("polhode_stepped");
  double off = 0;
  for (int n = 0; n <= 60 * 4; ++n) {
    const Vec3d L = handle.in_order(top.angular_momentum_body) / size;
    off = std::max(off, std::abs(L.dot(inverse.cwiseProduct(L)) / level - 1));
    if (n % 5 == 0) view.draw(points, {L});
    drift(top, 1.0 / 60);
  }
  support::Table through = open("polhode_through");
  view.draw(through, support::polhode(inverse, level, 0, 400));
  std::printf(
      "60 steps/s, thrown with 0.6 of the spin about the bar: the energy of the points\n"
      "is off by %.1e at most, |L| by nothing that shows\n\n",
      off);
  notebook.value("off", number("%.0e", off));
  support::expect(off < 1e-2, "the stepped points lie on the curve");
}

constexpr int step_with_arrows = 8;  // one with long pieces, on the near side

/// Turns the top about a body axis, and draws the way of the tip of L. Returns what lies in the
/// middle of it.
template <int axis>
std::array<Vec3d, 2> draw_turn(support::Table& table, const View& view, const Handle& handle,
                               Topd& top, double angle) {
  std::vector<Vec3d> arc;
  for (int n = 0; n <= 16; ++n) {
    Topd turned = top;
    turn_about_axis<axis>(turned, angle * n / 16);
    arc.push_back(handle.in_order(turned.angular_momentum_body).normalized());
  }
  view.draw(table, arc);
  turn_about_axis<axis>(top, angle);
  return {arc[8], arc[10]};
}

/// Steps of the splitting, so long that one sees their pieces.
void draw_pieces(support::Notebook& notebook, const Handle& handle) {
  const View view;
  const auto open = [&](const char* name) {
    return notebook.table(name, {"front x", "front y", "back x", "back y"});
  };
  support::Table half = open("pieces_half"), whole = open("pieces_whole"), ends = open("steps");
  Topd top = handle.thrown(0.6), at_once = top;
  support::expect(handle.axis[1] == 1 && handle.axis[2] == 2,
                  "the half turns are about axis 2, the whole ones about axis 3");
  const double h = 0.2, i_a = top.inverse_moments[0], energy = kinetic_energy(top);
  double off = 0;
  // One step has arrows.
  support::Table arrows = notebook.table("pieces_arrows", {"x", "y", "dx", "dy"});
  const auto point_along = [&](int step, const std::array<Vec3d, 2>& middle) {
    const Vec3d way = middle[1] - middle[0];
    if (step == step_with_arrows)
      arrows.row(view.right.dot(middle[0]), view.up.dot(middle[0]), view.right.dot(way),
                 view.up.dot(way));
  };
  for (int n = 0; n < 13; ++n) {
    const Vec3d& L = top.angular_momentum_body;
    view.draw(ends, {handle.in_order(L).normalized()});
    point_along(
        n, draw_turn<1>(half, view, handle, top, h / 2 * (top.inverse_moments[1] - i_a) * L[1]));
    point_along(n,
                draw_turn<2>(whole, view, handle, top, h * (top.inverse_moments[2] - i_a) * L[2]));
    point_along(
        n, draw_turn<1>(half, view, handle, top, h / 2 * (top.inverse_moments[1] - i_a) * L[1]));
    turn_by_splitting(at_once, h);
    support::expect((L - at_once.angular_momentum_body).norm() < 1e-12 * L.norm(),
                    "the pieces make the step");
    off = std::max(off, std::abs(kinetic_energy(top) / energy - 1));
  }
  notebook.value("pieces_off", number("%.0f %%", 100 * off));
  support::expect(off < 0.1, "the steps end beside the loop");
}

/// From one flip to the next, stepped: between two zeros of the rate about the shaft.
double stepped_wait(const Handle& handle, Topd top, double h) {
  double before = spin, first = 0;
  for (int n = 1;; ++n) {
    drift(top, h);
    const double now = angular_velocity_body(top)[handle.axis[1]];
    if (before * now < 0) {
      const double flip = (n - now / (now - before)) * h;
      if (first > 0) return flip - first;
      first = flip;
    }
    before = now;
  }
}

void wait_for_flips(support::Notebook& notebook, const Handle& handle) {
  const Vec3d I = handle.in_order(moments_of(handle.top));
  const double kappa = spin * std::sqrt((I[2] - I[1]) * (I[1] - I[0]) / (I[0] * I[2]));
  support::Table table =
      notebook.table("flip_times", {"wobble", "exact (s)", "stepped (s)", "straight line (s)"});
  std::printf("wobble   exact (s)  stepped (s)  longer by (s)\n");
  double last = 0;
  for (int n = 0; n <= 16; ++n) {
    const double wobble = std::pow(10, -n / 2.0);
    const Topd start = handle.thrown(wobble);
    const exact::FreeTop<double> exact(start);
    const double wait = exact.period() / 2, stepped = stepped_wait(handle, start, 1.0 / 480);
    table.row(wobble, wait, stepped, 2 * std::log(1 / wobble) / kappa);
    if (wobble > 5e-7)
      support::expect(std::abs(stepped / wait - 1) < 1e-3, "it flips when it should");
    if (n == 16) support::expect(stepped < 0.98 * wait, "rounding brings the flip forward");
    if (n % 2 != 0) continue;
    std::printf("10^-%d %12.4f %12.4f", n / 2, wait, stepped);
    std::printf(n > 0 ? " %12.4f\n" : "\n", wait - last);
    if (n >= 6)
      support::expect(std::abs((wait - last) * kappa / (2 * std::log(10)) - 1) < 1e-4,
                      "a tenth of the wobble adds the same wait each time");
    last = wait;
  }
  std::printf("(2 ln 10)/κ %27.4f\n", 2 * std::log(10) / kappa);
  notebook.value("ten_times", number("%.2f s", 2 * std::log(10) / kappa));
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Handle handle;
  draw_sphere(notebook, handle);
  draw_pieces(notebook, handle);
  wait_for_flips(notebook, handle);
}
