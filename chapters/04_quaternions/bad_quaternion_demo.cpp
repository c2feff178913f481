// What four numbers that are no orientation get: a sentence, before anything turns.
#include <support/refusals.hpp>
#include <tumble/rotation_matrix.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table = support::table_of_refusals(notebook, "bad_quaternions");
  int refused = 0;
  const auto orient = [&](const char* what, double real, const Vec3d& imaginary) {
    refused += support::try_it(table, what, "checked_orientation", [&] {
      checked_orientation(Quaterniond{real, imaginary}, "orientation of the book");
    });
  };
  orient("four zeros", 0, {0, 0, 0});
  orient("a component of 0/0", std::numeric_limits<double>::quiet_NaN(), {0, 0, 0});
  orient("a quaternion that is not normalised", 1, {1, 0, 0});
  orient("one that was typed to two digits", 0.71, {0.71, 0, 0});
  const auto turn = [&](const char* what, const Vec3d& axis, double angle) {
    refused +=
        support::try_it(table, what, "quaternion_about", [&] { quaternion_about(axis, angle); });
  };
  turn("a turn about no axis", {0, 0, 0}, 1.0);
  turn("a turn by ten million radians", {0, 0, 1}, 1e7);
  refused += support::try_it(table, "the matrix of a mirror", "quaternion_of",
                             [] { quaternion_of<double>(Vec3d(1, 1, -1).asDiagonal(), "camera"); });
  support::expect(refused == 6, "all but the one that was typed are refused");
}
