#include "run.hpp"

template tumble::simulate::ExitCode tumble::simulate::run<float>(const Options&);
