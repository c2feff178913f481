// Simulates a scene file: prints the plan, takes the steps, prints the books, writes what is asked
// for.
#include <cstdio>
#include <tumble/scene/scene_error.hpp>

#include "options.hpp"
#include "output_file.hpp"

namespace tumble::simulate {
template <class Real>
ExitCode run(const Options&);
extern template ExitCode run<float>(const Options&);
extern template ExitCode run<double>(const Options&);
}  // namespace tumble::simulate

int main(int argument_count, char** arguments) {
  using namespace tumble::simulate;
  try {
    const std::optional<Options> options = read_options(argument_count, arguments);
    if (!options) return all_simulated;
    return options->is_float ? run<float>(*options) : run<double>(*options);
  } catch (const UsageError& error) {
    std::fprintf(stderr, "simulate: %s\n", error.what());
    return bad_input;
  } catch (const tumble::SceneError& error) {
    std::fprintf(stderr, "simulate: %s\n", error.what());
    return bad_input;
  } catch (const FileError& error) {
    std::fprintf(stderr, "simulate: %s\n", error.what());
    return file_failed;
  }
}
