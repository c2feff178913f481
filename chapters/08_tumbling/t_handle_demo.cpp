// A T-handle is thrown in free fall, with its gyroscopic motion and without.
#include <numbers>
#include <support/record.hpp>
#include <support/recording.hpp>
#include <support/rules.hpp>

using namespace tumble;
using std::numbers::pi;
using support::number;

namespace {

const double seconds = 12, time_step = 1.0 / 60;

/// The drawn pose at every second step, for the player to replay.
support::Recording recorded(const char* title, void (*turn)(Topd&, double)) {
  support::Recording recording(title, 2 * time_step);
  std::vector<support::Part> parts;
  for (const auto& [cylinder, axes, centre] : support::t_handle_shape())
    parts.push_back(support::Part::cylinder(cylinder.radius, cylinder.height)
                        .at(Posed{.position = centre, .orientation = quaternion_of(axes)}));
  recording.add_body("T-handle", parts);
  ModelledBody<double> handle = support::thrown_t_handle();
  for (int n = 0; n * time_step <= seconds; ++n) {
    if (n % 2 == 0) recording.add_frame(std::array{drawn_pose(handle.body, handle.model_in_body)});
    turn(handle.body.top, time_step);
  }
  return recording;
}

/// ω in model axes: x along the bar, y along the shaft.
Vec3d in_model(const ModelledBody<double>& handle, const Vec3d& vector_body) {
  return rotate_back(handle.model_in_body.orientation, vector_body);
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  ModelledBody<double> handle = support::thrown_t_handle();
  ModelledBody<double> steady = handle;
  const exact::FreeTop<long double> exact(support::exactly(handle.body.top));
  const Vec3d moments = in_model(handle, moments_of(handle.body.top)).cwiseAbs();
  std::printf("moments about bar, shaft and the third axis: %.1e, %.1e, %.1e kg m^2\n", moments.x(),
              moments.y(), moments.z());
  support::expect(moments.x() < moments.y() && moments.y() < moments.z(),
                  "the shaft is the axis in the middle");
  const double between_flips = static_cast<double>(exact.period()) / 2;
  std::printf("exact time between two flips: %.4f s\n\n", between_flips);
  notebook.value("between_flips", number("%.2f s", between_flips));

  support::Table table = notebook.table("t_handle", {"time (s)", "about the shaft (rad/s)",
                                                     "exact (rad/s)", "without the term (rad/s)"});
  std::printf("flip at      since the last\n");
  double before = 0, last_flip = 0;
  int flips = 0;
  for (int n = 0; n * time_step <= seconds; ++n) {
    const double time = n * time_step;
    const Vec3d w = in_model(handle, angular_velocity_body(handle.body.top));
    const Vec3d truth = in_model(handle, angular_velocity_body(exact.at(time)).cast<double>());
    const Vec3d without = in_model(steady, angular_velocity_body(steady.body.top));
    table.row(time, w.y(), truth.y(), without.y());
    support::expect(std::abs(without.y() - 10) < 1e-9, "without the term it never flips");
    if (n > 0 && before * w.y() < 0) {
      const double flip = time - time_step * w.y() / (w.y() - before);
      if (flips == 0)
        std::printf("%7.3f s\n", flip);
      else
        std::printf("%7.3f s    %7.3f s\n", flip, flip - last_flip);
      support::expect(flips == 0 || std::abs(flip - last_flip - between_flips) < 0.002,
                      "flips come when the exact solution says");
      last_flip = flip;
      ++flips;
    }
    before = w.y();
    //! [two_ways]
    drift(handle.body.top, time_step);
    turn_steadily(steady.body.top, time_step);  // "no torque, so the angular velocity stays"
    //! [two_ways]
  }
  support::expect(flips >= 4, "the handle flips");
  notebook.value("flips", std::to_string(flips));
  notebook.value("seconds", number("%.0f", seconds));
  const Vec3d L0 = angular_momentum_world(support::thrown_t_handle().body.top);
  const auto tilt = [&](const Topd& top) {
    const Vec3d L = angular_momentum_world(top);
    return std::atan2(L.cross(L0).norm(), L.dot(L0)) * 180 / pi;
  };
  std::printf(
      "\nafter %.0f s the angular momentum points off by %.1e deg with the term, %.2f without\n",
      seconds, tilt(handle.body.top), tilt(steady.body.top));
  recorded("A", [](Topd& top, double h) {
    drift(top, h);
  }).write(notebook.file_in_folder("t_handle.recording.json"));
  recorded("B", [](Topd& top, double h) {
    turn_steadily(top, h);
  }).write(notebook.file_in_folder("t_handle_steady.recording.json"));
}
