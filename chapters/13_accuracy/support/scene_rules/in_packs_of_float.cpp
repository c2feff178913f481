#include <support/scene_rules.hpp>

template void tumble::support::SceneRules::choose(tumble::ManyBodies<float>&, std::size_t);
