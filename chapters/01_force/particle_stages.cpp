// The particle as it grows in chapter 1: each stage compiles and runs, and the page says what is
// wrong with it.
#include <support/record.hpp>
#include <tumble/particle.hpp>

using tumble::Vec3d;

//! [stage_1]
namespace first_try {
struct Particle {
  double mass;
  Vec3d acceleration;
  Vec3d position;
};
}  // namespace first_try
//! [stage_1]

//! [stage_2]
namespace second_try {
struct Particle {
  double inverse_mass;  // 1/mass; 0 means that nothing can move it
  Vec3d force;          // the sum of this step's forces
  Vec3d position;
};

Vec3d acceleration(const Particle& particle) {
  return particle.inverse_mass * particle.force;
}
}  // namespace second_try
//! [stage_2]

namespace third_try {
struct Particle {
  double inverse_mass;
  Vec3d force;
  Vec3d velocity;  // what a body keeps when nothing acts on it
  Vec3d position;
};
}  // namespace third_try

int main(int argument_count, char** arguments) {
  tumble::support::Notebook notebook(argument_count, arguments);
  const Vec3d force(0, 0, 12);

  first_try::Particle first{.mass = 3, .acceleration = force / 3, .position = Vec3d::Zero()};
  std::printf("first try:  a force of 12 N on %g kg gives %g m/s^2\n", first.mass,
              first.acceleration.z());

  const second_try::Particle second{
      .inverse_mass = 1.0 / 3, .force = force, .position = Vec3d::Zero()};
  const second_try::Particle wall{.inverse_mass = 0, .force = force, .position = Vec3d::Zero()};
  std::printf("second try: 1/m = %g /kg gives %g m/s^2\n", second.inverse_mass,
              acceleration(second).z());
  std::printf("            a wall, 1/m = 0, gives %g m/s^2\n", acceleration(wall).z());

  const third_try::Particle third{
      .inverse_mass = 1.0 / 3, .force = force, .velocity = {1, 0, 2}, .position = {0, 0, 0}};
  std::printf("third try:  it also remembers a velocity of (%g, %g, %g) m/s\n", third.velocity.x(),
              third.velocity.y(), third.velocity.z());

  notebook.value("size_double", std::to_string(sizeof(tumble::Particled)));
  notebook.value("size_float", std::to_string(sizeof(tumble::Particlef)));
}
