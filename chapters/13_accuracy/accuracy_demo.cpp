// What accuracy costs in time: every method on every problem.
#include <course/record.hpp>
#include <cstdlib>

#include "contests.hpp"

using namespace tumble::course;

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  const Effort effort = std::getenv("TUMBLE_FULL") ? full : quick;
  std::vector<Measurement> all;
  append(all, free_tops(effort));
  append(all, torqued_tops(effort));
  append(all, moving_points(effort));
  std::ofstream csv(notebook.file_in_folder("accuracy.csv"));
  csv << "problem,precision,method,kind,step,steps,error,energy error,momentum error,ns per run,ns "
         "per s\n";
  for (const Measurement& m : all)
    csv << '"' << m.problem << "\"," << m.precision << ",\"" << m.method << "\"," << m.kind << ','
        << number(m.knob) << ',' << m.steps << ',' << number("%.4g", m.error) << ','
        << number("%.4g", m.energy_error) << ',' << number("%.4g", m.momentum_error) << ','
        << number("%.4g", m.nanoseconds) << ',' << number("%.4g", m.nanoseconds / m.seconds)
        << '\n';
}
