#include <tumble/world.hpp>

namespace tumble {
TUMBLE_WORLD(, float)
TUMBLE_WORLD(, double)
}  // namespace tumble
