// Masses that can be dragged, live, and the axes that follow them.
#include <support/live.hpp>
#include <tumble/mass_properties.hpp>
#include <tumble/principal_axes.hpp>

using namespace tumble;

void tumble::support::run_live(Live& live) {
  const double heavy = live.knob("heavy", "kg", 2, 0.1, 5);
  const double apart = live.knob("apart", "m", 0.4, 0, 2);

  // Where the masses lie as seen from above, m: x and y of each in turn.
  std::vector<double> places = {0.75, 0.15, -0.6, 0.3, -0.25, -0.55, 0.1, 0.45};
  if (!live.drawn().empty()) {
    if (live.drawn().size() != places.size())
      reject("number of coordinates", live.drawn().size(), "", "four masses have 8");
    for (std::size_t n = 0; n < places.size(); ++n) {
      require_between("coordinate of a mass", live.drawn()[n], "m", -1, 1);
      places[n] = live.drawn()[n];
    }
  }

  // Each mass is two halves, one above the other.
  std::vector<Particled> halves;
  std::vector<double>&x = live.column("x", "m"), &y = live.column("y", "m"),
  &mass = live.column("mass", "kg");
  for (std::size_t n = 0; n < places.size() / 2; ++n) {
    x.push_back(places[2 * n]);
    y.push_back(places[2 * n + 1]);
    mass.push_back(n == 0 ? heavy : 1);
    for (const double side : {0.5, -0.5})
      halves.push_back(make_particle(mass[n] / 2, Vec3d(x[n], y[n], side * apart)));
  }
  const MassPropertiesd all = mass_properties(halves);
  const PrincipalAxes<double> principal = principal_axes(all.inertia);

  std::vector<double>& centre = live.column("centre", "m");
  centre.push_back(all.centre_of_mass.x());
  centre.push_back(all.centre_of_mass.y());
  std::vector<double>& moments = live.column("moments", "kg m²");
  for (int axis = 0; axis < 3; ++axis) moments.push_back(principal.moments[axis]);
  for (const int row : {0, 1, 2}) {
    std::vector<double>& part = live.column(std::string("axes ") + "xyz"[row], "");
    for (int axis = 0; axis < 3; ++axis) part.push_back(principal.axes(row, axis));
  }
}
