#include <tumble/in_packs.hpp>

namespace tumble {
TUMBLE_MANY_BODIES(, float)
}  // namespace tumble
