#include "simulated_scene.hpp"

template tumble::simulate::SceneInPacks<float> tumble::simulate::scene_of<float>(const Options&);
