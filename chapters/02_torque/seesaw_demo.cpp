// A seesaw in balance, and the torque of its forces about different points.
#include <support/record.hpp>
#include <tumble/torque.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [seesaw]
  const Vec3d heavier(-1.0, 0, 0), lighter(1.5, 0, 0);  // where they sit, from the pivot
  Wrenchd children;                                     // about the pivot, which is the origin
  add_force_at(children, Vec3d(0, 0, -300), heavier);
  add_force_at(children, Vec3d(0, 0, -200), lighter);

  Wrenchd everything = children;
  add_force_at(everything, Vec3d(0, 0, 500), Vec3d(0, 0, 0));  // the pivot holds both up
  //! [seesaw]
  support::Table drawing =
      notebook.table("seesaw", {"kind", "x (m)", "z (m)", "dx (m)", "dz (m)", "text"});
  // They balance, so that the weights are to each other as the distances, the other way round.
  const double weight = -children.force.z(), board = lighter.x() - heavier.x();
  for (const auto& [child, other] : {std::pair{heavier, lighter}, {lighter, heavier}}) {
    const double share = weight * std::abs(other.x()) / board;
    drawing.row("weight", child.x(), 0.0, 0.0, -share / 400, support::number("%.0f N", share));
  }
  std::printf("torque about           the children alone   with the pivot's force\n");
  const auto row = [&](const char* name, const Vec3d& point) {
    std::printf("%-20s   %14.0f N m   %18.0f N m\n", name, taken_about(children, point).torque.y(),
                taken_about(everything, point).torque.y());
  };
  row("the pivot", Vec3d(0, 0, 0));
  row("a lamp 2 m above it", Vec3d(0, 0, 2));
  row("the heavier child", heavier);
  row("the lighter child", lighter);
  row("a tree 10 m away", Vec3d(10, 0, 0));
}
