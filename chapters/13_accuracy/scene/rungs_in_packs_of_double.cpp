#include <course/scene_rules.hpp>

template void tumble::course::SceneRules::choose(tumble::ManyBodies<double>&, std::size_t);
