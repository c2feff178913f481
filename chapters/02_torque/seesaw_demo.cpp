// A seesaw in balance, and the torque of its forces about different points.
#include <support/record.hpp>
#include <tumble/torque.hpp>
#include <tuple>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [seesaw]
  Wrenchd children;  // about the pivot, which is the origin
  add_force_at(children, Vec3d(0, 0, -300), Vec3d(-1.0, 0, 0));
  add_force_at(children, Vec3d(0, 0, -200), Vec3d(1.5, 0, 0));

  Wrenchd everything = children;
  add_force_at(everything, Vec3d(0, 0, 500), Vec3d(0, 0, 0));  // the pivot holds both up
  //! [seesaw]
  support::Table drawing =
      notebook.table("seesaw", {"kind", "x (m)", "z (m)", "dx (m)", "dz (m)", "text"});
  for (const auto& [at, weight, name] :
       {std::tuple{-1.0, 300.0, "300 N"}, std::tuple{1.5, 200.0, "200 N"}})
    drawing.row("weight", at, 0.0, 0.0, -weight / 400, name);
  std::printf("torque about           the children alone   with the pivot's force\n");
  const auto row = [&](const char* name, const Vec3d& point) {
    std::printf("%-20s   %14.0f N m   %18.0f N m\n", name, taken_about(children, point).torque.y(),
                taken_about(everything, point).torque.y());
  };
  row("the pivot", Vec3d(0, 0, 0));
  row("a lamp 2 m above it", Vec3d(0, 0, 2));
  row("the heavier child", Vec3d(-1.0, 0, 0));
  row("the lighter child", Vec3d(1.5, 0, 0));
  row("a tree 10 m away", Vec3d(10, 0, 0));
}
