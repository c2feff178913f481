#include <peers/peers.hpp>

namespace peers {

const std::vector<Library>& libraries() {
  static const std::vector<Library> all = {
      {"Odeint", odeint_on_top},
#ifdef TUMBLE_HAS_SIMBODY
      {"Simbody", simbody_on_top},
#endif
#ifdef TUMBLE_HAS_BULLET
      {"Bullet", bullet_on_top},
#endif
#ifdef TUMBLE_HAS_ODE
      {"ODE", ode_on_top},
#endif
  };
  return all;
}

}  // namespace peers
