// A needle with moments of 1, 1 and 10^-6 kg m^2 in float: where are the digits lost?
#include <Eigen/Eigenvalues>
#include <random>
#include <support/record.hpp>
#include <tumble/rigid_body.hpp>

using namespace tumble;

namespace {

Vec3<long double> exactly(const Vec3f& v) {
  return v.cast<long double>();
}

/// The same top in long double: what the float's own numbers mean.
Top<long double> witness_of(const Topf& top) {
  Top<long double> witness;
  witness.orientation =
      normalized(Quaternion<long double>{top.orientation.real, exactly(top.orientation.imaginary)});
  witness.inverse_moments = exactly(top.inverse_moments);
  witness.angular_momentum_body = exactly(top.angular_momentum_body);
  return witness;
}

/// Any orientation: four components between -1 and 1, normalised.
Quaternionf random_orientation(std::mt19937_64& generator) {
  const auto component = [&generator] {
    return static_cast<float>(std::ldexp(static_cast<double>(generator() >> 11), -52) - 1);
  };
  const float w = component(), x = component(), y = component(), z = component();
  return normalized(Quaternionf{w, {x, y, z}});
}

double error(const Vec3f& answer, const Vec3<long double>& truth) {
  return static_cast<double>((exactly(answer) - truth).norm() / truth.norm());
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::mt19937_64 generator(5);
  double small_moment = 0, tensor = 0, in_and_out = 0, stored_in_body = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Topf top{.orientation = random_orientation(generator), .inverse_moments = Vec3f(1, 1, 1e6f)};
    const Top<long double> unspun = witness_of(top);
    const Mat3d formed = world_inertia(top).cast<double>();
    const Eigen::SelfAdjointEigenSolver<Mat3d> solver(formed);
    small_moment = std::max(small_moment, std::abs(solver.eigenvalues()(0) / 1e-6 - 1));

    // A torque across the needle, rounded to float: that rounding is part of the question.
    const Vec3f across = rotate(unspun.orientation, Vec3<long double>(1, 0, 0)).cast<float>();
    const Vec3<long double> truth = inverse_inertia_times(unspun, exactly(across));
    tensor = std::max(tensor, error(world_inverse_inertia(top) * across, truth));
    in_and_out = std::max(in_and_out, error(inverse_inertia_times(top, across), truth));

    top.angular_momentum_body = {1, 0.5f, 2e-4f};
    stored_in_body = std::max(stored_in_body, error(angular_velocity_world(top),
                                                    angular_velocity_world(witness_of(top))));
  }
  std::printf("largest relative error in 1000 orientations, float\n\n");
  std::printf("small moment of the tensor R I R^T           %8.1e\n", small_moment);
  std::printf("answer to a world vector perpendicular to the needle\n");
  std::printf("  by the tensor R I^-1 R^T                   %8.1e\n", tensor);
  std::printf("  rotated in, divided, rotated out           %8.1e\n", in_and_out);
  std::printf("angular velocity from body-frame momentum    %8.1e\n", stored_in_body);
  notebook.value("small_moment", support::number("%.0f %%", 100 * small_moment));
  notebook.value("tensor", support::number("%.0f %%", 100 * tensor));
  notebook.value("stored_in_body", support::number("%.0e", stored_in_body));
  support::expect(small_moment > 0.01,
                  "the tensor formed in float has lost the small moment's digits");
  support::expect(tensor > 0.1 && in_and_out > 0.1, "a world vector has lost them already");
  support::expect(stored_in_body < 2e-6, "a momentum kept in body axes has not");
}
