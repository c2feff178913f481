#include <course/random_world.hpp>
#include <tumble/in_packs.hpp>

namespace tumble {

template ManyBodies<float> course::random_world(course::Dice&, std::size_t);
template void course::meddle(ManyBodies<float>&, course::Dice&, int);
template BodyHandle course::add_random_body(ManyBodies<float>&, course::Dice&, const std::string&);
template void course::add_random_effect(ManyBodies<float>&, course::Dice&,
                                        const std::vector<BodyHandle>&);

}  // namespace tumble
