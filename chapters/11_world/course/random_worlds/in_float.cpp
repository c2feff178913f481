#include <course/random_world.hpp>

namespace tumble {

template World<float> course::random_world(course::Dice&, std::size_t);
template void course::meddle(World<float>&, course::Dice&, int);
template BodyHandle course::add_random_body(World<float>&, course::Dice&, const std::string&);
template void course::add_random_effect(World<float>&, course::Dice&,
                                        const std::vector<BodyHandle>&);

}  // namespace tumble
