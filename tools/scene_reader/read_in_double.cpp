#include <tumble/scene/read_scene_text.hpp>

namespace tumble {

template Scene<double> read_scene_text(std::string_view, const std::string&, const SceneChanges&,
                                       std::span<const std::string>);
template void FirstTurningRules::choose(World<double>&, std::size_t);

}  // namespace tumble
