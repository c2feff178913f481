#include <support/random_world.hpp>

namespace tumble {

template World<double> support::random_world(support::Dice&, std::size_t);
template void support::meddle(World<double>&, support::Dice&, int);
template BodyHandle support::add_random_body(World<double>&, support::Dice&, const std::string&);
template void support::add_random_effect(World<double>&, support::Dice&,
                                         const std::vector<BodyHandle>&);

}  // namespace tumble
