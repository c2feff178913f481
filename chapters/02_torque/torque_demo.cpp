// A door pushed at different places; and what the page's two diagrams are drawn from.
#include <numbers>
#include <support/record.hpp>
#include <tumble/torque.hpp>

using namespace tumble;
using std::numbers::pi;

namespace {

/// A row for each thing of a diagram: what it is, where it begins and how far it goes, or its name.
class Diagram {
 public:
  Diagram(const support::Notebook& notebook, std::string_view name)
      : table_(notebook.table(name, {"kind", "x (m)", "y (m)", "dx (m)", "dy (m)", "text"})) {}
  void arrow(const char* kind, const Vec3d& from, const Vec3d& by) {
    table_.row(kind, from.x(), from.y(), by.x(), by.y(), "");
  }
  void label(const Vec3d& at, const char* text) {
    table_.row("label", at.x(), at.y(), 0.0, 0.0, text);
  }
  /// A rounded body about the origin, half as high as it is wide.
  void body() {
    for (int degree = 0; degree <= 360; degree += 3) {
      const double angle = degree * pi / 180;
      const auto rounded = [](double c) { return std::copysign(std::sqrt(std::abs(c)), c); };
      table_.row("body", 2.2 * rounded(std::cos(angle)), 1.1 * rounded(std::sin(angle)), 0.0, 0.0,
                 "");
    }
  }

 private:
  support::Table table_;
};

void draw_lever_arm(const support::Notebook& notebook) {
  const Vec3d centre(0, 0, 0), point(1.7, 0.6, 0), force(0.5, 1.5, 0);
  const Vec3d along = force.normalized();
  const Vec3d foot = point - along * along.dot(point - centre);
  Diagram diagram(notebook, "lever_arm");
  diagram.body();
  diagram.arrow("line", foot - 1.0 * along, 3.6 * along);
  diagram.arrow("distance", centre, foot - centre);
  diagram.arrow("arm", centre, point - centre);
  diagram.arrow("force", point, force);
  diagram.arrow("dot", centre, Vec3d::Zero());
  diagram.arrow("dot", point, Vec3d::Zero());
  // The mark of a right angle.
  const Vec3d inwards = (centre - foot).normalized();
  diagram.arrow("square", foot + 0.16 * along, 0.16 * inwards);
  diagram.arrow("square", foot + 0.16 * inwards, 0.16 * along);
  diagram.label(centre + Vec3d(-0.25, 0.2, 0), "x");
  diagram.label(point + Vec3d(0.25, -0.05, 0), "p");
  diagram.label(point + force + Vec3d(0.25, 0, 0), "F");
  diagram.label((centre + point) / 2 + Vec3d(-0.35, 0.2, 0), "p - x");
  diagram.label((centre + foot) / 2 + Vec3d(0, -0.3, 0), "d");
}

void draw_couple(const support::Notebook& notebook) {
  const Vec3d here(1.6, 0.5, 0), there(-1.6, -0.5, 0), force(0.2, 1.4, 0);
  const Vec3d along = force.normalized(), across = (here - there) - along * along.dot(here - there);
  Diagram diagram(notebook, "couple");
  diagram.body();
  diagram.arrow("line", there + across - 0.4 * along, here - there - across + 0.4 * along);
  diagram.arrow("distance", there, across);
  // Which way the pair turns the body.
  const double turned = std::copysign(1.0, torque_about(there, here, force).z());
  const auto on_circle = [](double angle) {
    return Vec3d(0.42 * std::cos(angle), 0.42 * std::sin(angle), 0);
  };
  for (int n = 0; n <= 20; ++n) {
    const double from = turned * (-0.6 + 0.2 * n), to = from + turned * (n < 20 ? 0.2 : 0.5);
    diagram.arrow(n < 20 ? "turn" : "turn head", on_circle(from), on_circle(to) - on_circle(from));
  }
  diagram.label(there + across / 2 + Vec3d(0, -0.28, 0), "d");
  diagram.arrow("arm", there, here - there);
  diagram.arrow("force", here, force);
  diagram.arrow("force", there, -force);
  diagram.arrow("dot", here, Vec3d::Zero());
  diagram.arrow("dot", there, Vec3d::Zero());
  diagram.label(here + force + Vec3d(0.3, 0, 0), "F");
  diagram.label(there - force + Vec3d(-0.35, 0, 0), "-F");
  diagram.label(here + Vec3d(0.3, -0.1, 0), "p");
  diagram.label(there + Vec3d(-0.3, 0.1, 0), "q");
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [door]
  const Vec3d hinge(0, 0, 0), handle(0.8, 0, 0), middle(0.4, 0, 0);
  const double from_behind = torque_about(hinge, handle, Vec3d(0, -10, 0)).z();
  const double twice_in_the_middle = torque_about(hinge, middle, Vec3d(0, 20, 0)).z();
  const Vec3d askew = 10 * Vec3d(std::cos(pi / 6), std::sin(pi / 6), 0);
  const double at_30_degrees = torque_about(hinge, handle, askew).z();
  //! [door]
  std::printf("10 N at the handle, from behind:         %4.1f N m\n", from_behind);
  std::printf("20 N in the middle, 0.4 m from the hinge: %3.1f N m\n", twice_in_the_middle);
  std::printf("10 N at the handle, at 30 degrees:        %3.1f N m\n", at_30_degrees);
  draw_lever_arm(notebook);
  draw_couple(notebook);
}
