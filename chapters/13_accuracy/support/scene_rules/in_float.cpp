#include <support/scene_rules.hpp>

template void tumble::support::SceneRules::choose(tumble::World<float>&, std::size_t);
