#include "simulated_scene.hpp"

template tumble::simulate::SceneInPacks<double> tumble::simulate::scene_of<double>(const Options&);
