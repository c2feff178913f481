#include <course/random_world.hpp>
#include <tumble/in_packs.hpp>

namespace tumble {

template ManyBodies<double> course::random_world(course::Dice&, std::size_t);
template void course::meddle(ManyBodies<double>&, course::Dice&, int);
template BodyHandle course::add_random_body(ManyBodies<double>&, course::Dice&, const std::string&);
template void course::add_random_effect(ManyBodies<double>&, course::Dice&,
                                        const std::vector<BodyHandle>&);

}  // namespace tumble
