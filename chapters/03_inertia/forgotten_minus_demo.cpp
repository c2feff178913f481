// A mistake, run on purpose: a product of inertia read with the other sign convention.
#include <support/record.hpp>
#include <tumble/solids.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;
using support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  // A bar that lies aslant, from the lower left to the upper right.
  //! [slanted_bar]
  const double angle = 0.5;
  const Mat3d slant = Eigen::AngleAxisd(angle, Vec3d::UnitZ()).toRotationMatrix();
  const MassPropertiesd bar =
      moved(mass_properties(Box<double>{{2, 0.2, 0.2}}, 3), slant, {0, 0, 0});
  Mat3d misread = -bar.inertia;  // every sign turned round ...
  misread.diagonal() *= -1;      // ... but those of the moments
  //! [slanted_bar]
  const auto print = [](const char* name, const Mat3d& inertia) {
    require_invertible_inertia("bar", inertia);
    const auto [moments, axes] = principal_axes(inertia);
    const Vec3d easy = axes.col(0) * (axes(0, 0) < 0 ? -1 : 1);
    const double degrees = std::atan2(easy.y(), easy.x()) * 180 / 3.141592653589793;
    std::printf("%-10s I_xy %6.3f   moments %.3f %.3f %.3f   easiest axis at %5.1f degrees\n", name,
                inertia(0, 1), moments.x(), moments.y(), moments.z(), degrees);
    return degrees;
  };
  const double right = print("right", bar.inertia), wrong = print("misread", misread);
  support::expect(std::abs(right + wrong) < 1e-9,
                  "the misread bar lies in the mirror, with the same moments");
  notebook.value("right", number("%.1f", right));
  notebook.value("wrong", number("%.1f", wrong));
}
