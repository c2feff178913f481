#include "kept_in_scene.hpp"

template double scene_error<float>(const Json&, const Json&);
