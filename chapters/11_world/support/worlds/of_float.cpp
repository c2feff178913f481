#include <tumble/world.hpp>

namespace tumble {
TUMBLE_WORLD(, float)
}  // namespace tumble
