#include <support/scene_rules.hpp>

template void tumble::support::SceneRules::choose(tumble::World<float>&, std::size_t);
template void tumble::support::SceneRules::choose(tumble::World<double>&, std::size_t);
template void tumble::support::SceneRules::choose(tumble::ManyBodies<float>&, std::size_t);
template void tumble::support::SceneRules::choose(tumble::ManyBodies<double>&, std::size_t);
