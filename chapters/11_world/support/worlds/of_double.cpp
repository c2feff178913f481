#include <tumble/world.hpp>

namespace tumble {
TUMBLE_WORLD(, double)
}  // namespace tumble
