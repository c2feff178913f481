// Four mistakes with the tensor, run on purpose, on a body that shows them and on one that hides
// three.
#include <support/record.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/spheres.hpp>

using namespace tumble;

namespace {

using Mat4d = Eigen::Matrix<double, 4, 4>;

//! [mistakes]
/// The engine's 4 × 4 transform, whose last column is the body's place.
Mat4d transform_of(const Bodyd& body) {
  Mat4d transform = Mat4d::Identity();
  transform.topLeftCorner<3, 3>() = matrix_of(body.top.orientation);
  transform.topRightCorner<3, 1>() = body.centre.position;
  return transform;
}

/// "Transpose what must be inverted": the tensor is its own transpose, so it is used as it is.
Vec3d transposed(const Bodyd& body, const Vec3d& torque) {
  return world_inertia(body.top).transpose() * torque;
}

/// "A matrix turns by one multiplication": R I⁻¹ without the Rᵀ.
Vec3d one_side(const Bodyd& body, const Vec3d& torque) {
  return matrix_of(body.top.orientation) * body.top.inverse_moments.asDiagonal() * torque;
}

/// Row-vector code copied into column-vector code: Rᵀ I⁻¹ R.
Vec3d other_way_round(const Bodyd& body, const Vec3d& torque) {
  const Mat3d R = matrix_of(body.top.orientation);
  return R.transpose() * body.top.inverse_moments.asDiagonal() * R * torque;
}

/// "The transform takes vectors to the world": it takes points. A torque is moved as well as
/// turned.
Vec3d moved_as_well(const Bodyd& body, const Vec3d& torque) {
  const Mat4d transform = transform_of(body);
  const Vec3d in_body = (transform.inverse() * torque.homogeneous()).head<3>();
  const Vec3d answer = body.top.inverse_moments.cwiseProduct(in_body);
  return (transform * answer.homogeneous()).head<3>();
}
//! [mistakes]

Bodyd placed(const MassProperties<double>& shape) {
  const Posed pose{.position = {5, 0, 2}, .orientation = quaternion_about(Vec3d(1, 2, 3), 1.0)};
  return make_rigid_body("body", shape, pose).body;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Bodyd brick = placed(mass_properties(Box<double>{{1, 2, 3}}, 2.0));
  const Bodyd ball = placed(mass_properties(Sphere<double>{0.5}, 10.0));  // 1 kg m² about any axis
  const Vec3d torque(1, 0, 0);
  const auto error = [&](const Bodyd& body, Vec3d (*mistake)(const Bodyd&, const Vec3d&)) {
    const Vec3d right = inverse_inertia_times(body.top, torque);
    return (mistake(body, torque) - right).norm() / right.norm();
  };
  const auto report = [&](const char* name, Vec3d (*mistake)(const Bodyd&, const Vec3d&),
                          bool ball_shows_it) {
    std::printf("%-32s %8.0f %% %8.0f %%\n", name, 100 * error(brick, mistake),
                100 * error(ball, mistake));
    support::expect(error(brick, mistake) > 0.1, "the brick shows every mistake");
    support::expect((error(ball, mistake) > 0.1) == ball_shows_it,
                    "the ball shows only what we say");
  };
  std::printf("error of the answer to a torque     brick       ball\n");
  report("transposed, not inverted", transposed, false);
  report("multiplied on one side only", one_side, true);
  report("the two sides exchanged", other_way_round, false);
  report("moved as well as turned", moved_as_well, false);

  std::printf("\na blow of 1 N s at 1 m from the centre   right          transposed\n");
  for (const double mass : {1.0, 2.0, 4.0}) {
    Bodyd body = placed(mass_properties(Box<double>{{1, 2, 3}}, mass));
    const Vec3d right = inverse_inertia_times(body.top, torque);
    std::printf("box of %.0f kg                          %6.3f rad/s   %6.3f rad/s\n", mass,
                right.norm(), transposed(body, torque).norm());
  }
  const auto size = [&](double mass) {
    return transposed(placed(mass_properties(Box<double>{{1, 2, 3}}, mass)), torque).norm();
  };
  support::expect(std::abs(size(4.0) - 4 * size(1.0)) < 1e-12 * size(4.0),
                  "without the inverse, four times the mass answers four times as much");
}
