// Both precisions in one file: what they share, such as the parser of JSON, is compiled once.
#include <tumble/scene/read_scene_text.hpp>

namespace tumble {

template Scene<float> read_scene_text(std::string_view, const std::string&, const SceneChanges&,
                                      std::span<const std::string>);
template Scene<double> read_scene_text(std::string_view, const std::string&, const SceneChanges&,
                                       std::span<const std::string>);
template void FirstTurningRules::choose(World<float>&, std::size_t);
template void FirstTurningRules::choose(World<double>&, std::size_t);

}  // namespace tumble
