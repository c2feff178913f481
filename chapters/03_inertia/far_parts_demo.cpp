// A mistake, run on purpose: a compound body summed about the model's origin and shifted back, in
// float.
#include <support/record.hpp>
#include <tumble/spheres.hpp>

using namespace tumble;
using support::number;

namespace {

/// The textbook's formula, taken literally: every part to the origin, the sum back to its centre.
//! [by_way_of_the_origin]
MassPropertiesf by_way_of_the_origin(const std::vector<MassPropertiesf>& parts) {
  MassPropertiesf whole;
  for (const MassPropertiesf& part : parts) {
    whole.mass += part.mass;
    whole.centre_of_mass += part.mass * part.centre_of_mass;
    whole.inertia += inertia_about(part, Vec3f::Zero());
  }
  whole.centre_of_mass /= whole.mass;
  const Vec3f origin = Vec3f::Zero();
  return from_inertia_about(origin, whole.inertia, whole.mass, whole.centre_of_mass);
}
//! [by_way_of_the_origin]

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table =
      notebook.table("far_parts", {"distance (m)", "by way of the origin", "seen from within"});
  const MassPropertiesf light = mass_properties(Sphere<float>{0.1f}, 2.2f);
  const MassPropertiesf heavy = mass_properties(Sphere<float>{0.1f}, 3.1f);
  const Mat3f upright = Mat3f::Identity();
  const auto parts_at = [&](float distance) {
    return std::vector{moved(light, upright, {distance, -0.5f, 0}),
                       moved(heavy, upright, {distance, 0.5f, 0})};
  };
  const float truth = combined(parts_at(0)).inertia(2, 2);
  std::printf("a dumbbell of 2.2 kg and 3.1 kg, 1 m apart; I_z should be %.4f kg m^2\n\n", truth);
  std::printf("distance from   by way of     seen from\n");
  std::printf("the origin (m)  the origin    within\n");
  bool lost = false, kept = true;
  for (const float distance : {1.f, 3.f, 10.f, 30.f, 100.f, 300.f, 1000.f, 3000.f, 10000.f}) {
    const float naive = by_way_of_the_origin(parts_at(distance)).inertia(2, 2);
    const float careful = combined(parts_at(distance)).inertia(2, 2);
    table.row(double(distance), double(std::abs(naive - truth) / truth),
              double(std::abs(careful - truth) / truth));
    lost = lost || std::abs(naive - truth) >= truth;
    kept = kept && std::abs(careful - truth) <= 4e-7f * truth;
    std::printf("%14.0f  %10.4f    %.4f\n", distance, naive, careful);
    const double error = double(std::abs(naive - truth) / truth);
    if (distance == 3) notebook.value("error_3", number("%.0e", error));
    if (distance == 10000) notebook.value("error_10000", number("%.0f", error));
    if (distance == 1000) notebook.value("at_1000", number("%.3g kg m²", naive));
  }
  support::expect(lost, "far away the sum has lost the body altogether");
  support::expect(kept, "seen from within, the body keeps its digits");
  notebook.value("truth", number("%.4f kg m²", truth));
}
