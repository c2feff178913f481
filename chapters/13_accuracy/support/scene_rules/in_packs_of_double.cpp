#include <support/scene_rules.hpp>

template void tumble::support::SceneRules::choose(tumble::ManyBodies<double>&, std::size_t);
