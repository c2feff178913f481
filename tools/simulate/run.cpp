// What depends on the precision, for both in one file: what they share is compiled once.
#include "run.hpp"

#include "check_plan.hpp"

namespace tumble::simulate {

template ExitCode run<float>(const Options&);
template ExitCode run<double>(const Options&);
template ExitCode check_plan<float>(const Options&);
template ExitCode check_plan<double>(const Options&);

}  // namespace tumble::simulate
