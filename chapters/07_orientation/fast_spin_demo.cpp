// A wheel that turns by half a turn and more in every step.
#include <numbers>
#include <support/record.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using std::numbers::pi;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("asked in one step    the pose is off by   it looks like   first order\n");
  for (const double turn : {3.0, pi, 3.3, 6.0, 2 * pi, 7.0, 1000.0, 3.0e6}) {
    const Vec3d omega(0, 0, turn);
    const Quaterniond q = turn_exponential<double>({}, omega, 1);
    const double seen = rotation_vector_of(q).z();  // the shortest turn that ends so
    const long double two_pi = 2 * std::numbers::pi_v<long double>;
    const double error = std::abs(
        static_cast<double>(std::remainder(seen - static_cast<long double>(turn), two_pi)));
    std::printf("%12.4f rad   %18.0e   %+9.4f rad   %7.4f rad\n", turn, error,
                std::round(seen * 1e4) / 1e4 + 0.0,  // without the sign of a rounded zero

                rotation_vector_of(turn_first_order<double>({}, omega, 1)).z());
    support::expect(error < 1e-15 * (4 + turn), "the pose is the one that was asked for");
  }
  try {
    require_turn(Vec3d(0, 0, 4e8), 1.0 / 60);
    support::expect(false, "a turn beyond the limit is refused");
  } catch (const std::invalid_argument& error) {
    std::printf("\n%s\n", error.what());
  }
}
