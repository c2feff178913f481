/// @file
/// What takes the compiler longest, compiled once for all exercises.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exercise/todo.hpp>
#include <exercise/wire.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <tumble/require.hpp>
#include <vector>
