#include "kept_in_scene.hpp"

template double scene_error<double>(const Json&, const Json&);
