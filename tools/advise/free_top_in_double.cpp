#include "free_top_rungs.hpp"

template void tumble::advise::append_free_top<double>(std::vector<Candidate>&,
                                                      const FreeTopQuestion&, const Frames&,
                                                      const StepKinds&, double);
