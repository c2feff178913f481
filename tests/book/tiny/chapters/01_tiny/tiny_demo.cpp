// Prints the one number, and draws a line that ends there.
#include <course/record.hpp>
#include <tumble/tiny.hpp>

using tumble::course::number;

int main(int argument_count, char** arguments) {
  tumble::course::Notebook notebook(argument_count, arguments);
  const double length = tumble::stick_length();
  std::printf("The stick is %.2f m long.\n", length);
  notebook.value("length", number("%.2f m", length));
  tumble::course::Table line = notebook.table("line", {"time (s)", "length (m)"});
  line.row(0.0, 0.0);
  line.row(1.0, length);
}
