#include <tumble/make_rigid_body.hpp>

namespace tumble {
TUMBLE_BODIES(, float)
TUMBLE_BODIES(, double)
}  // namespace tumble
