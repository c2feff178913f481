//! [whole]
// A rigid body in ninety lines: a T-handle is thrown upwards, spinning about its shaft, and flips.
#include <array>
#include <cmath>
#include <cstdio>

using Vector = std::array<double, 3>;

struct Body {
  double mass;                                        // kg
  Vector moments;                                     // kg m², about its axes 0, 1 and 2
  Vector position = {0, 0, 0}, velocity = {0, 0, 0};  // m, m/s, of its centre of mass, world axes
  double w = 1;                                       // w and q: the quaternion
  Vector q = {0, 0, 0};                               // that leads from its axes to the world's
  Vector angular_momentum = {0, 0, 0};                // L, kg m²/s, body axes
};

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Force and torque, both in world axes, act for `time` seconds. Chapters 1, 2 and 5.
void kick(Body& body, const Vector& force, const Vector& torque, double time) {
  const Vector a = cross(torque, body.q), b = cross(a, body.q);  // into body axes: chapter 4
  for (std::size_t k = 0; k < 3; ++k) {
    body.velocity[k] += time * force[k] / body.mass;
    body.angular_momentum[k] += time * (torque[k] + 2 * (body.w * a[k] + b[k]));
  }
}

// Turns the arrow (a, b) in its plane, from b towards a.
void turn(double& a, double& b, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), a_before = a;
  a = c * a + s * b;
  b = c * b - s * a_before;
}

// The body turns as if its axis k were the only one: L stands still in the world. Chapter 8.
void turn_about_axis(Body& body, std::size_t k, double time) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  //! [turn]
  const double angle = time * body.angular_momentum[k] / body.moments[k];
  turn(body.angular_momentum[i], body.angular_momentum[j], angle);
  turn(body.q[k], body.w, angle / 2);
  turn(body.q[i], body.q[j], angle / 2);
  //! [turn]
}

// No force for `time` seconds: it coasts, and turns about its axes one after the other and back.
void drift(Body& body, double time) {
  for (std::size_t k = 0; k < 3; ++k) body.position[k] += time * body.velocity[k];
  turn_about_axis(body, 0, time / 2);
  turn_about_axis(body, 1, time / 2);
  turn_about_axis(body, 2, time);
  turn_about_axis(body, 1, time / 2);
  turn_about_axis(body, 0, time / 2);
}

// An aluminium bar of 12 cm along axis 0 and a shaft of 6 cm along axis 1, thrown. Chapter 3.
Body thrown_t_handle() {
  const double pi = std::acos(-1.0), R = 0.008, H = 0.12, r = 0.01, h = 0.06;
  const double bar = 2700 * pi * R * R * H, shaft = 2700 * pi * r * r * h, apart = R + h / 2;
  const double between = apart * apart * bar * shaft / (bar + shaft);  // about their common centre
  const double I_bar = bar * (R * R / 4 + H * H / 12), I_shaft = shaft * (r * r / 4 + h * h / 12);
  const Vector moments = {bar * R * R / 2 + I_shaft + between, I_bar + shaft * r * r / 2,
                          I_bar + I_shaft + between};
  return {.mass = bar + shaft,
          .moments = moments,
          .velocity = {0, 0, 60},
          .angular_momentum = {0.1 * moments[0], 10 * moments[1], 0}};  // 10 rad/s about the shaft
}

int main() {
  Body body = thrown_t_handle();
  const Vector& L = body.angular_momentum;
  const double time_step = 1.0 / 60;
  for (int n = 0; n < 12 * 60; ++n) {
    const double before = L[1];
    kick(body, {0, 0, -9.81 * body.mass}, {0, 0, 0}, time_step);  // weight, but no torque
    drift(body, time_step);
    if (before * L[1] > 0) continue;
    const double flip = time_step * (n + before / (before - L[1]));
    double energy = 0;
    for (std::size_t k = 0; k < 3; ++k) energy += L[k] * L[k] / body.moments[k] / 2;
    std::printf("flips at %6.3f s, %3.0f m up: turning energy %.6f J, |L| %.15f kg m²/s\n", flip,
                body.position[2], energy, std::hypot(L[0], L[1], L[2]));
  }
  return 0;
}
//! [whole]
