// The multiplication table of i, j and k, made by the product itself.
#include <support/record.hpp>
#include <tumble/quaternion.hpp>

using namespace tumble;

namespace {

/// "-k" for a quaternion that is minus k.
std::string name_of(const Quaterniond& q) {
  const double components[] = {q.real, q.imaginary.x(), q.imaginary.y(), q.imaginary.z()};
  const char* const names[] = {"1", "i", "j", "k"};
  std::string name;
  for (int n = 0; n < 4; ++n)
    if (components[n] != 0) name += (components[n] < 0 ? std::string("-") : "") + names[n];
  return name;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Quaterniond one, i = pure<double>({1, 0, 0}), j = pure<double>({0, 1, 0}),
                         k = pure<double>({0, 0, 1});
  std::printf(" p q |  q = 1     i     j     k\n-----+------------------------\n");
  for (const Quaterniond& p : {one, i, j, k}) {
    std::printf("p =%2s|", name_of(p).c_str());
    for (const Quaterniond& q : {one, i, j, k}) std::printf("%6s", name_of(p * q).c_str());
    std::printf("\n");
  }
  support::expect(name_of(i * j * k) == "-1", "ijk = -1");

  notebook.value("size_double", std::to_string(sizeof(Quaterniond)));
  notebook.value("matrix_double", std::to_string(sizeof(Mat3d)));
}
