#include <course/scene_rules.hpp>

template void tumble::course::SceneRules::choose(tumble::World<double>&, std::size_t);
