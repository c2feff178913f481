#include <tumble/in_packs.hpp>
#include <tumble/scene/read_scene_text.hpp>

namespace tumble {

template Scene<float, InPacks<float>> read_scene_text(std::string_view, const std::string&,
                                                      const SceneChanges&,
                                                      std::span<const std::string>);
template Scene<double, InPacks<double>> read_scene_text(std::string_view, const std::string&,
                                                        const SceneChanges&,
                                                        std::span<const std::string>);

}  // namespace tumble
