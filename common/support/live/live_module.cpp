// A live figure as a module of WebAssembly. The page writes knobs, drawn numbers and texts where
// live_knobs(), live_drawn() and live_texts() say, calls live_run(), and reads the JSON that it
// returns: beside each column stands where its numbers lie.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <support/live.hpp>
#include <tumble/explained.hpp>
#include <typeinfo>

namespace {

using tumble::support::Live;

std::vector<double> knobs, drawn;
std::string texts;
Live live;
std::string answer;

double* resized(std::vector<double>& numbers, int count) {
  numbers.resize(static_cast<std::size_t>(count));
  return numbers.data();
}

}  // namespace

extern "C" {

[[clang::export_name("live_knobs")]] double* live_knobs(int count) {
  return resized(knobs, count);
}

[[clang::export_name("live_drawn")]] double* live_drawn(int count) {
  return resized(drawn, count);
}

[[clang::export_name("live_texts")]] char* live_texts(int count) {
  texts.resize(static_cast<std::size_t>(count));
  return texts.data();
}

[[clang::export_name("live_run")]] const char* live_run() {
  answer.clear();
  live = Live(knobs, drawn, texts);
  tumble::support::run_live(live);
  const auto with_place = [](std::string& json, const Live::Column& column) {
    const auto at = reinterpret_cast<std::uintptr_t>(column.values.data());
    json.append(",\"at\":").append(tumble::text_of(at));
    json.append(",\"length\":").append(tumble::text_of(column.values.size()));
  };
  answer = as_json(live, with_place);
  return answer.c_str();
}

/// After a run that was broken off: why; empty where the memory did not suffice.
[[clang::export_name("live_refusal")]] const char* live_refusal() {
  return answer.c_str();
}

// Debian's C++ library for WebAssembly has no exceptions. Whatever is thrown here is a refusal and
// ends the run: the page reads its sentence, drops the module and makes a new one.
void* __cxa_allocate_exception(std::size_t size) noexcept {
  return std::malloc(size);
}

[[noreturn]] void __cxa_throw(void* thrown, std::type_info*, void (*)(void*)) {
  const auto& exception = *static_cast<std::exception*>(thrown);
  if (tumble::tell_of_throw) tumble::tell_of_throw(exception);
  answer = exception.what();
  __builtin_trap();
}

void __cxa_free_exception(void* thrown) noexcept {
  std::free(thrown);
}

}  // extern "C"
