// A hammer is put into the world by its model, thrown, and drawn by its model again.
#include <numbers>
#include <support/hammer.hpp>
#include <support/record.hpp>

using namespace tumble;
using std::numbers::pi;

namespace {

/// What the page's diagram of the three frames is drawn from.
void draw_frames(const support::Notebook& notebook, const ModelledBody<double>& made) {
  support::Table table =
      notebook.table("frames", {"kind", "x (m)", "y (m)", "dx (m)", "dy (m)", "text"});
  const auto row = [&](const std::string& kind, const Vec3d& from, const Vec3d& by,
                       const char* text = "") {
    table.row(kind, from.x(), from.y(), by.x(), by.y(), text);
  };
  const Posed drawn = drawn_pose(made.body, made.model_in_body), physical = pose_of(made.body);
  for (const Vec3d& corner : support::hammer_outline())
    row("body", point_outward(drawn, corner), Vec3d::Zero());
  const auto arrow_of = [&](const std::string& kind, const Posed& pose, int axis,
                            const char* text) {
    const Vec3d arrow = rotate<double>(pose.orientation, 0.12 * Vec3d::Unit(axis));
    row(kind, pose.position, arrow);
    row(kind + " name", pose.position + 1.16 * arrow, Vec3d::Zero(), text);
  };
  for (const auto& [kind, pose] : {std::pair("world", Posed{}), std::pair("model", drawn)}) {
    arrow_of(kind, pose, 0, "x");
    arrow_of(kind, pose, 1, "y");
  }
  // Of the body's axes, those two that lie in the page; which ones they are is the solver's choice.
  for (const int axis : {0, 1, 2})
    if (std::abs(rotate<double>(physical.orientation, Vec3d::Unit(axis)).z()) < 0.5)
      arrow_of("principal", physical, axis, std::array{"1", "2", "3"}[std::size_t(axis)]);
  row("world name", Vec3d(0.01, -0.025, 0), Vec3d::Zero(), "world");
  row("model name", drawn.position + Vec3d(-0.035, -0.02, 0), Vec3d::Zero(), "model");
  row("principal name", physical.position + Vec3d(0.1, -0.012, 0), Vec3d::Zero(), "body");
  // The offset as a bar beside the handle.
  const Vec3d offset = physical.position - drawn.position;
  const Vec3d aside = 0.075 * Vec3d(offset.y(), -offset.x(), 0).normalized();
  row("offset", drawn.position + aside, offset);
  for (const Posed* end : {&drawn, &physical}) row("to the offset", end->position, 1.15 * aside);
  row("offset name", drawn.position + 0.5 * offset + 1.25 * aside, Vec3d::Zero(),
      "offset, constant");
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [make]
  const Posed model_in_world{.position = {0.25, 0.1, 0},
                             .orientation = quaternion_about(Vec3d(0, 0, 1), 0.5)};
  ModelledBody<double> made = make_rigid_body("hammer", support::hammer(), model_in_world);
  //! [make]
  draw_frames(notebook, made);
  const Vec3d moments = moments_of(made.body.top);
  std::printf("mass               %.3f kg\n", mass_of(made.body.centre));
  std::printf("centre of mass     %.1f mm from the handle's end\n",
              1000 * support::hammer().centre_of_mass.x());
  std::printf("principal moments  %.2e, %.2e, %.2e kg m^2\n", moments.x(), moments.y(),
              moments.z());

  // The throw. The hammer turns about z, which is a principal axis, so it turns steadily.
  const double spin = 3 * pi, time_step = 1.0 / 240;
  made.body.centre.velocity = {1.6, 3.2, 0};
  const Quaterniond start = made.body.top.orientation;
  support::Table paths = notebook.table(
      "forgotten_offset_paths",
      {"x of the centre of mass (m)", "y (m)", "x of the head without offset (m)", "y (m)"});
  support::Table outlines = notebook.table(
      "forgotten_offset", {"x (m)", "y (m)", "x without offset (m)", "y without offset (m)"});
  for (int n = 0; n <= 160; ++n) {
    made.body.top.orientation = quaternion_about(Vec3d(0, 0, 1), spin * n * time_step) * start;
    //! [draw]
    const Posed drawn = drawn_pose(made.body, made.model_in_body);
    //! [draw]
    const Vec3d centre = made.body.centre.position;
    const Posed forgotten{.position = centre, .orientation = drawn.orientation};
    const Vec3d head(support::Hammer::handle_length + support::Hammer::head_width / 2, 0, 0);
    const Vec3d wrong_head = point_outward(forgotten, head);
    paths.row(centre.x(), centre.y(), wrong_head.x(), wrong_head.y());
    const Vec3d at_centre = point_outward(drawn, support::hammer().centre_of_mass);
    support::expect((at_centre - centre).norm() < 1e-12, "the drawn centre of mass is the body's");
    if (n % 32 == 0) {  // every 72°
      for (const Vec3d& corner : support::hammer_outline()) {
        const Vec3d right = point_outward(drawn, corner), wrong = point_outward(forgotten, corner);
        outlines.row(right.x(), right.y(), wrong.x(), wrong.y());
      }
      outlines.row("nan", "nan", "nan", "nan");  // lifts the pen
    }
    add_gravity<double>(made.body.centre, {0, -9.81, 0});
    step(made.body.centre, time_step);
    clear_forces(made.body);
  }
}
