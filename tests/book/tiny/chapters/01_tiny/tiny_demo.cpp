// Prints the one number, draws a line that ends there, and records the stick as it rises.
#include <support/record.hpp>
#include <support/recording.hpp>
#include <tumble/tiny.hpp>

using tumble::support::number;

namespace {

struct Orientation {
  double real = 1;
  tumble::Vec3d imaginary = {0, 0, 0};
};

struct Pose {
  tumble::Vec3d position;
  Orientation orientation = {};
};

}  // namespace

int main(int argument_count, char** arguments) {
  tumble::support::Notebook notebook(argument_count, arguments);
  const double length = tumble::stick_length();
  std::printf("The stick is %.2f m long.\n", length);
  notebook.value("length", number("%.2f m", length));
  tumble::support::Table line = notebook.table("line", {"time (s)", "length (m)"});
  line.row(0.0, 0.0);
  line.row(1.0, length);
  tumble::support::Recording rising("The stick rises", 0.5);
  rising.add_body("stick", {tumble::support::Part::cylinder(0.05, length)});
  for (const double height : {0.0, 1.0}) rising.add_frame(std::array{Pose{{0, 0, height}}});
  rising.write(notebook.file_in_folder("stick.recording.json"));
  tumble::support::expect(length < 2.1, "the stick is hardly longer than two metres");
}
