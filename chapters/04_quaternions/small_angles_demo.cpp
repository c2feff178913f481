// Mistakes, run on purpose: formulas that are right on paper and lose small angles.
#include <numbers>
#include <support/record.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

//! [arc_cosine]
double angle_by_arc_cosine(const Quaterniond& q) {
  return 2 * std::acos(std::abs(q.real));
}
//! [arc_cosine]

Quaterniond unguarded_exponential(const Vec3d& v) {
  const double angle = v.norm();
  return {.real = std::cos(angle / 2), .imaginary = std::sin(angle / 2) / angle * v};
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("turned by (rad)   by arc cosine   angle_between   logarithm\n");
  double arc_cosine = 0;
  for (const double angle : {1.0, 1e-3, 1e-6, 1e-7, 1e-8, 1e-9, 1e-300}) {
    const Quaterniond q = quaternion_of_rotation_vector(Vec3d(0, 0, angle));
    arc_cosine = angle_by_arc_cosine(q);
    const double between = angle_between({}, q), logarithm = rotation_vector_of(q).z();
    std::printf("%15g   %13.6g   %13.6g   %9.6g\n", angle, arc_cosine, between, logarithm);
    support::expect(std::abs(between - angle) <= 1e-15 * angle, "angle_between keeps its digits");
    support::expect(std::abs(logarithm - angle) <= 1e-15 * angle, "so does the logarithm");
  }
  support::expect(arc_cosine == 0, "the arc cosine loses small angles altogether");

  const double limit = 2 * SineCosineConstants<float>::limit;
  notebook.value("limit_float", support::number("%.0f", limit));
  notebook.value("angle_float", support::number("%.0f", SineCosineConstants<float>::limit));
  notebook.value("angle_double", support::number("%.0f", SineCosineConstants<double>::limit));
  notebook.value("terms_float", std::to_string(SineCosineConstants<float>::terms));
  notebook.value("terms_double", std::to_string(SineCosineConstants<double>::terms));
  // Whole turns that fit: rounded to the nearest it would be one that doesn't.
  const int turns = static_cast<int>(limit / (2 * std::numbers::pi));
  notebook.value("turns_float", std::to_string(turns));
  const auto answered = [](int whole_turns) {
    const auto angle = static_cast<float>(whole_turns * 2 * std::numbers::pi);
    return std::isfinite(quaternion_of_rotation_vector(Vec3f(0, 0, angle)).real);
  };
  support::expect(answered(turns) && !answered(turns + 1), "so many whole turns, and no more");
  std::printf("\nturned by (rad)   sin(angle/2)/angle v   the exponential of v/2\n");
  for (const double angle : {1e-3, 1e-160, 1e-200, 0.0}) {
    const Vec3d v(0, 0, angle);
    const double unguarded = unguarded_exponential(v).imaginary.z(),
                 ours = quaternion_of_rotation_vector(v).imaginary.z();
    std::printf("%15g   %20s   %22g\n", angle,
                std::isnan(unguarded) ? "NaN" : support::number("%g", unguarded).c_str(), ours);
    support::expect(std::abs(ours - angle / 2) <= 1e-7 * angle, "half the angle");
    if (angle < 1e-170) support::expect(!std::isfinite(unguarded), "0/0 and x/0 are not finite");
  }
}
