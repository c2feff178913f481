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
  diagram.label(centre + Vec3d(-0.25, 0.2, 0), "x");
  diagram.label(point + Vec3d(0.25, -0.05, 0), "p");
  diagram.label(point + force + Vec3d(0.25, 0, 0), "F");
  diagram.label((centre + point) / 2 + Vec3d(-0.35, 0.2, 0), "p - x");
  diagram.label((centre + foot) / 2 + Vec3d(0, -0.3, 0), "d");
}

void draw_couple(const support::Notebook& notebook) {
  const Vec3d here(1.6, 0.5, 0), there(-1.6, -0.5, 0), force(0.2, 1.4, 0);
  Diagram diagram(notebook, "couple");
  diagram.body();
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
  const Vec3d push(0, 10, 0);
  const double at_the_handle = torque_about(hinge, handle, push).z();
  const double in_the_middle = torque_about(hinge, middle, push).z();
  const double along_the_door = torque_about(hinge, handle, Vec3d(-10, 0, 0)).z();
  //! [door]
  std::printf("10 N at the handle, 0.8 m from the hinge:   %4.1f N m\n", at_the_handle);
  std::printf("10 N in the middle, 0.4 m from the hinge:   %4.1f N m\n", in_the_middle);
  std::printf("10 N at the handle, towards the hinge:      %4.1f N m\n", along_the_door);
  draw_lever_arm(notebook);
  draw_couple(notebook);
}
