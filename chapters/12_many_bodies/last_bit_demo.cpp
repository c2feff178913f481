// What becomes of a difference in the last bit of one number.
#include <limits>
#include <support/record.hpp>
#include <tumble/gravity.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

constexpr int rate = 120, seconds = 40;

/// Two balls on springs, one below the other, held out level and let go; the lower one lies `nudge`
/// further out, m.
template <class Real>
World<Real> swing(Real nudge) {
  World<Real> world(steps_per_second(rate));
  const BodyHandle upper = world.add("upper", make_particle<Real>(1, {1, 0, 0}));
  const BodyHandle lower = world.add("lower", make_particle<Real>(1, {2 + nudge, 0, 0}));
  world.add(Gravity<Real>{});
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 300, .rest_length = 1}}, {upper});
  world.add(SpringBetween<Real>{.spring = {.stiffness = 300, .rest_length = 1}}, {upper, lower});
  return world;
}

/// How far apart the lower balls of two such worlds are after each tenth of a second, m, if they
/// began one bit apart.
template <class Real>
std::vector<double> distances() {
  World<Real> one = swing<Real>(0), other = swing<Real>(2 * std::numeric_limits<Real>::epsilon());
  std::vector<double> found;
  for (int n = 0; n < 10 * seconds; ++n) {
    for (int step = 0; step < rate / 10; ++step) {
      one.step();
      other.step();
    }
    found.push_back(
        double((one.position(one.find("lower")) - other.position(other.find("lower"))).norm()));
  }
  return found;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const std::vector<double> in_float = distances<float>(), in_double = distances<double>();
  support::Table table = notebook.table("last_bit", {"time (s)", "float (m)", "double (m)"});
  for (std::size_t n = 0; n < in_float.size(); ++n)
    table.row(0.1 * double(n + 1), in_float[n], in_double[n]);
  const auto parting = [](const std::vector<double>& distance) {
    std::size_t n = 0;
    while (n < distance.size() && distance[n] < 0.1) ++n;
    support::expect(n < distance.size(), "the two motions part");
    return support::number("%.0f", 0.1 * double(n + 1));
  };
  notebook.value("parts_in_float", parting(in_float) + " s");
  notebook.value("parts_in_double", parting(in_double) + " s");
  std::printf("The balls are 10 cm apart after %s s in float, and after %s s in double.\n",
              parting(in_float).c_str(), parting(in_double).c_str());
}
