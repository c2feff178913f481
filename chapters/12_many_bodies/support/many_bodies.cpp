#include <tumble/in_packs.hpp>

namespace tumble {
TUMBLE_MANY_BODIES(, float)
TUMBLE_MANY_BODIES(, double)
}  // namespace tumble
