// The sphere of L, live: a rule from an engine turns a body about its stable axis.
#include <support/energy_sphere.hpp>

void tumble::support::run_live(Live& live) {
  energy_sphere::run(live, {.rule = 2, .time_step = 0.05, .wobble = 0.1, .about = 2});
}
