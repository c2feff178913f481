// Says what accuracy costs on this machine: the cheapest method and step for a wanted error,
// confirmed.
#include <cstdio>
#include <new>
#include <tumble/failure.hpp>
#include <tumble/scene/scene_error.hpp>

#include "answer.hpp"

namespace {

/// Prints what is said. @return `code`, or that it can't be written
int written(const std::string& said, int code) {
  if (std::fputs(said.c_str(), stdout) != EOF && std::fflush(stdout) == 0) return code;
  std::fputs("advise: the answer can't be written\n", stderr);
  return tumble::advise::refused;
}

}  // namespace

int main(int argument_count, char** arguments) {
  using namespace tumble::advise;
  try {
    const std::optional<Options> options = read_options(argument_count, arguments);
    if (!options) return written("", confirmed);
    const Answer answer = answer_to(*options);
    return written(options->json ? json_of(answer) : text_of(answer),
                   answer.verdict.winner ? confirmed : refused);
  } catch (const UsageError& error) {
    std::fprintf(stderr, "advise: %s\n", error.what());
    return bad_input;
  } catch (const tumble::SceneError& error) {
    std::fprintf(stderr, "advise: %s\n", error.what());
    return bad_input;
  } catch (const tumble::SimulationError& error) {
    std::fprintf(stderr, "advise: the scene can't be run: %s\n", error.what());
    return refused;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "advise: the memory does not suffice for this question\n");
    return refused;
  } catch (const std::exception& error) {  // what leads beyond the range of numbers
    std::fprintf(stderr, "advise: this can't be computed: %s\n", error.what());
    return refused;
  }
}
