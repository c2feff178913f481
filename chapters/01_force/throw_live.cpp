// The thrown ball, live: its first velocity, the time step, and gravity in both ways.
#include <support/live.hpp>
#include <tumble/force.hpp>

using namespace tumble;

void tumble::support::run_live(Live& live) {
  const double h = live.knob("h", "s", 0.1, 0.005, 0.5);
  const int way = live.choice("gravity", 0, 2);
  const double mass = live.knob("mass", "kg", 0.5, 0.01, 100);
  const double forward = live.knob("forward", "m/s", 8, -12, 12);
  const double up = live.knob("up", "m/s", 10, 0, 15);

  const Vec3d velocity(forward, 0, up), gravity(0, 0, -9.81);
  std::vector<double>&time = live.column("time", "s"), &distances = live.column("distance", "m"),
  &heights = live.column("height", "m"), &exact_distances = live.column("exact distance", "m"),
  &exact_heights = live.column("exact height", "m"),
  &below = live.column("below the parabola", "m"), &predicted = live.column("half g h t", "m");
  Particled ball = make_particle(mass, Vec3d::Zero(), velocity);
  const int steps = static_cast<int>(2 / h);
  for (int n = 0; n <= steps; ++n) {
    const double t = n * h;
    time.push_back(t);
    distances.push_back(ball.position.x());
    heights.push_back(ball.position.z());
    below.push_back(t * velocity.z() + t * t / 2 * gravity.z() - ball.position.z());
    predicted.push_back(-gravity.z() * h * t / 2);
    if (way == 0)
      add_gravity(ball, gravity);
    else
      accelerate(ball, gravity, h);
    step(ball, h);
    clear_force(ball);
  }
  for (int n = 0; n <= 80; ++n) {
    const double t = steps * h * n / 80;
    exact_distances.push_back(t * velocity.x());
    exact_heights.push_back(t * velocity.z() + t * t / 2 * gravity.z());
  }
}
