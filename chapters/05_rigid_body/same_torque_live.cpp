// The same torque on a turned body, live: what it does when it is taken for what it is, and when
// its world numbers are put into a vector of the body's axes.
#include <numbers>
#include <support/live.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

using namespace tumble;

void tumble::support::run_live(Live& live) {
  const double degree = std::numbers::pi / 180;
  const double about_x = live.knob("about x", "°", 40, -180, 180) * degree;
  const double about_z = live.knob("about z", "°", 0, -180, 180) * degree;
  const double direction = live.knob("direction", "°", 90, 0, 180) * degree;
  const int frame = live.choice("frame", 0, 2);

  // A satellite of 10 kg, twice as long as wide; a torque of 1 N m for a second, in the plane of
  // the world's x and z.
  const auto satellite = mass_properties(Box<double>{{1, 1, 2}}, 10.0);
  const Posed pose{.orientation = quaternion_about(Vec3d(0, 0, 1), about_z) *
                                  quaternion_about(Vec3d(1, 0, 0), about_x)};
  const auto [sine, cosine] = sine_cosine(direction);
  const Vec3d torque(cosine, 0, sine);
  const ModelledBody<double> made = make_rigid_body("satellite", satellite, pose);
  Bodyd body = made.body, right = made.body;
  add_angular_momentum(right.top, torque);
  if (frame == 0)
    body = right;
  else
    body.top.angular_momentum_body += torque;  // the mistake

  const auto push = [&live](const std::string& name, const char* unit, const Vec3d& v) {
    live.column(name, unit).assign({v.x(), v.y(), v.z()});
  };
  push("torque", "N m", torque);
  push("omega", "rad/s", angular_velocity_world(body.top));
  push("right", "rad/s", angular_velocity_world(right.top));
  const Quaterniond q = body.top.orientation * made.model_in_body.orientation;
  live.column("pose", "").assign({q.real, q.imaginary.x(), q.imaginary.y(), q.imaginary.z()});

  // How both answer as the body is rolled on about x.
  std::vector<double>&rolled = live.column("rolled", "°"),
  &rights = live.column("right along", "rad/s"), &wrongs = live.column("wrong along", "rad/s");
  for (int n = 0; n <= 72; ++n) {
    const double roll = -180 + 5.0 * n;
    Bodyd turned = made.body;
    turned.top.orientation = quaternion_about(Vec3d(0, 0, 1), about_z) *
                             quaternion_about(Vec3d(1, 0, 0), roll * degree) *
                             conjugate(made.model_in_body.orientation);
    Bodyd mistaken = turned;
    add_angular_momentum(turned.top, torque);
    mistaken.top.angular_momentum_body += torque;
    rolled.push_back(roll);
    rights.push_back(dot(angular_velocity_world(turned.top), torque));
    wrongs.push_back(dot(angular_velocity_world(mistaken.top), torque));
  }
}
