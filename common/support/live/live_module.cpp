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

/// The texts by their names. Of each: its name, a zero, how many bytes it has, a zero, its bytes.
Live::Texts written() {
  Live::Texts by_name;
  std::string_view rest = texts;
  const auto take = [&rest](std::size_t count) {
    const std::string_view front = rest.substr(0, count);
    rest.remove_prefix(front.size());
    return std::string(front);
  };
  while (!rest.empty()) {
    const std::string name = take(rest.find('\0'));
    take(1);
    const std::string length = take(rest.find('\0'));
    take(1);
    by_name[name] = take(std::strtoul(length.c_str(), nullptr, 10));
  }
  return by_name;
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
  live = Live(knobs, drawn, written());
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
  tumble::Explaining::tell(exception);
  answer = exception.what();
  __builtin_trap();
}

void __cxa_free_exception(void* thrown) noexcept {
  std::free(thrown);
}

}  // extern "C"
