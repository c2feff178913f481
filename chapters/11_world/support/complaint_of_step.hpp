/// @file
/// For two runs that must stop at the same step and say the same.
#pragma once

#include <string>
#include <tumble/failure.hpp>

namespace tumble::support {

/// Takes a step by calling `step`. @return why that can't be done, or nothing if it was
template <class Step>
std::string complaint_of_step(const Step& step) {
  try {
    step();
  } catch (const SimulationError& error) {
    return error.what();
  }
  return {};
}

}  // namespace tumble::support
