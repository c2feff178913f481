#include <course/scene_rules.hpp>

template void tumble::course::SceneRules::choose(tumble::ManyBodies<float>&, std::size_t);
