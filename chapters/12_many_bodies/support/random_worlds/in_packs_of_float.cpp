#include <support/random_world.hpp>
#include <tumble/in_packs.hpp>

namespace tumble {

template ManyBodies<float> support::random_world(support::RandomGenerator&, std::size_t);
template void support::meddle(ManyBodies<float>&, support::RandomGenerator&, int);
template BodyHandle support::add_random_body(ManyBodies<float>&, support::RandomGenerator&,
                                             const std::string&);
template void support::add_random_effect(ManyBodies<float>&, support::RandomGenerator&,
                                         const std::vector<BodyHandle>&);

}  // namespace tumble
