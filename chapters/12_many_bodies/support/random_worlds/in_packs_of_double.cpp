#include <support/random_world.hpp>
#include <tumble/in_packs.hpp>

namespace tumble {

template ManyBodies<double> support::random_world(support::RandomGenerator&, std::size_t);
template void support::meddle(ManyBodies<double>&, support::RandomGenerator&, int);
template BodyHandle support::add_random_body(ManyBodies<double>&, support::RandomGenerator&,
                                             const std::string&);
template void support::add_random_effect(ManyBodies<double>&, support::RandomGenerator&,
                                         const std::vector<BodyHandle>&);

}  // namespace tumble
