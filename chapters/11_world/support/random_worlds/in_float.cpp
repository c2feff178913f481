#include <support/random_world.hpp>

namespace tumble {

template World<float> support::random_world(support::RandomGenerator&, std::size_t);
template void support::meddle(World<float>&, support::RandomGenerator&, int);
template BodyHandle support::add_random_body(World<float>&, support::RandomGenerator&,
                                             const std::string&);
template void support::add_random_effect(World<float>&, support::RandomGenerator&,
                                         const std::vector<BodyHandle>&);

}  // namespace tumble
