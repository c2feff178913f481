#include <support/scene_rules.hpp>

template void tumble::support::SceneRules::choose(tumble::World<double>&, std::size_t);
