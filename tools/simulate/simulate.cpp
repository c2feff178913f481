// Simulates a scene file: prints the plan, takes the steps, prints the books, writes what is asked
// for.
#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>
#include <tumble/scene/scene_error.hpp>

#include "check_plan.hpp"
#include "live_page.hpp"
#include "run.hpp"

namespace tumble::simulate {
namespace {

int said(const char* what, ExitCode code) {
  std::fprintf(stderr, "simulate: %s\n", what);
  return code;
}

int answer(int argument_count, char** arguments) {
  try {
    const std::optional<Options> options = read_options(argument_count, arguments);
    if (!options) return all_simulated;
    if (options->check_plan)
      return options->is_float ? check_plan<float>(*options) : check_plan<double>(*options);
    if (!options->live.empty()) {
      write_live_page(*options);
      return all_simulated;
    }
    return options->is_float ? run<float>(*options) : run<double>(*options);
  } catch (const UsageError& error) {
    return said(error.what(), bad_input);
  } catch (const SceneError& error) {
    return said(error.what(), bad_input);
  } catch (const FileError& error) {
    return said(error.what(), file_failed);
  } catch (const std::filesystem::filesystem_error& error) {
    return said(error.what(), file_failed);
  } catch (const std::bad_alloc&) {
    return said("the memory does not suffice for this scene and what is recorded of it",
                too_little);
  } catch (const std::system_error& error) {
    return said(
        (std::string("the system refuses: ") + error.what() + "; fewer --threads may do").c_str(),
        too_little);
  } catch (const std::exception& error) {  // such as a place that no replay can hold
    return said(error.what(), file_failed);
  }
}

}  // namespace
}  // namespace tumble::simulate

int main(int argument_count, char** arguments) {
  using namespace tumble::simulate;
  if (!occupy_standard_descriptors()) return file_failed;
  const int code = answer(argument_count, arguments);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  if (ended_by == SIGPIPE) return interrupted + SIGPIPE;  // who has gone needs no sentence
  return said("what is printed can't be written; the disk may be full", file_failed);
}
