#include "run.hpp"

template tumble::simulate::ExitCode tumble::simulate::run<double>(const Options&);
