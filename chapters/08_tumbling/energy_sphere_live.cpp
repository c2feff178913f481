// The sphere of L, live: the splitting turns a body about its middle axis.
#include <support/energy_sphere.hpp>

void tumble::support::run_live(Live& live) {
  energy_sphere::run(live);
}
