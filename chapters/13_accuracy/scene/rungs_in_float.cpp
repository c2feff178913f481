#include <course/scene_rules.hpp>

template void tumble::course::SceneRules::choose(tumble::World<float>&, std::size_t);
