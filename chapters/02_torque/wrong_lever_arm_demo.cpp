// A mistake, run on purpose: the lever arm taken from the world's origin, or from the mesh's.
#include <support/record.hpp>
#include <tumble/torque.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table =
      notebook.table("wrong_lever_arm", {"distance of the body (m)", "centre of mass (N m)",
                                         "world origin (N m)", "mesh origin (N m)"});
  // A crate 2 m long is pushed at its right end. Its mesh was modelled from the left end.
  const Vec3d push(0, 10, 0), from_centre_to_end(1, 0, 0), from_centre_to_mesh_origin(-1, 0, 0);
  std::printf("crate at   right: about the   wrong: about the   wrong: about the\n");
  std::printf("           centre of mass     world's origin     mesh's origin\n");
  for (int metres = 0; metres <= 50; metres += 5) {
    const Vec3d centre(metres, 0, 0), point = centre + from_centre_to_end;
    const double right = torque_about(centre, point, push).z();
    const double about_world_origin = torque_about<double>(Vec3d::Zero(), point, push).z();
    const double about_mesh_origin =
        torque_about<double>(centre + from_centre_to_mesh_origin, point, push).z();
    table.row(metres, right, about_world_origin, about_mesh_origin);
    if (metres % 25 == 0)
      std::printf("%4d m     %10.0f N m   %12.0f N m   %12.0f N m\n", metres, right,
                  about_world_origin, about_mesh_origin);
    support::expect(right == 10, "the right torque does not depend on where the crate stands");
    support::expect(about_world_origin == 10 * (metres + 1), "the wrong one grows with distance");
    support::expect(about_mesh_origin == 20, "the mesh's origin doubles the arm");
  }
  // Pushed between the two, half a metre from the left end.
  const double right = torque_about<double>({0, 0, 0}, {-0.5, 0, 0}, push).z();
  const double wrong = torque_about<double>(from_centre_to_mesh_origin, {-0.5, 0, 0}, push).z();
  support::expect(right < 0 && wrong > 0, "between the two origins even the sign is wrong");
  notebook.value("between_right", support::number("%.0f N m", right));
  notebook.value("between_wrong", support::number("%.0f N m", wrong));
}
