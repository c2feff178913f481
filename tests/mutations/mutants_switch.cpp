// Which mutant runs: the one whose number the environment names.
#include <cstdlib>

#include "mutants.hpp"

namespace tumble_mutants {

int chosen_number = 0;
unsigned char seen[most];

namespace {

/// Before any other static variable gets its value, since that may depend on the mutant.
__attribute__((constructor(101))) void choose() {
  if (const char* number = std::getenv("TUMBLE_MUTANT")) chosen_number = std::atoi(number);
}

}  // namespace
}  // namespace tumble_mutants
