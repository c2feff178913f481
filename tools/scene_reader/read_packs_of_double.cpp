#include <tumble/in_packs.hpp>
#include <tumble/scene/read_scene_text.hpp>

template tumble::Scene<double, tumble::InPacks<double>> tumble::read_scene_text(
    std::string_view, const std::string&, const SceneChanges&, std::span<const std::string>);
