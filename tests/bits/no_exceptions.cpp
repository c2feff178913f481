// For WebAssembly, where the C++ library has no exceptions: whatever is thrown ends the program.
#include <cstdlib>
#include <typeinfo>

extern "C" {
void* __cxa_allocate_exception(std::size_t size) noexcept {
  return std::malloc(size);
}
void __cxa_free_exception(void* thrown) noexcept {
  std::free(thrown);
}
[[noreturn]] void __cxa_throw(void*, std::type_info*, void (*)(void*)) {
  std::abort();
}
}
