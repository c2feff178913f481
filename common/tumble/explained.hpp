/// @file
/// Adds to a refusal what only the caller knows, such as the place in a file where the number
/// stands.
#pragma once

#include <functional>
#include <stdexcept>
#include <utility>

namespace tumble {

#ifdef __wasi__
/// WASI's C++ library can't catch. There, whatever stands in for throwing calls this before it ends
/// the program, so that those who wait can explain a refusal by another; null where nobody waits.
inline void (*tell_of_throw)(const std::exception& thrown) = nullptr;

namespace detail {

/// One who waits. The innermost is asked first.
class Explaining {
 public:
  explicit Explaining(std::function<void(const std::invalid_argument&)> explain)
      : explain_(std::move(explain)), outer_(std::exchange(innermost_, this)) {
    tell_of_throw = ask_innermost;
  }
  Explaining(const Explaining&) = delete;
  Explaining& operator=(const Explaining&) = delete;
  ~Explaining() { innermost_ = outer_; }

 private:
  static void ask_innermost(const std::exception& thrown) {
    const auto* refusal = dynamic_cast<const std::invalid_argument*>(&thrown);
    if (!refusal || !innermost_) return;
    const Explaining* asked = std::exchange(innermost_, innermost_->outer_);
    asked->explain_(*refusal);
  }

  std::function<void(const std::invalid_argument&)> explain_;
  Explaining* outer_;
  static inline Explaining* innermost_ = nullptr;
};

}  // namespace detail

#endif

/// What `action` returns. Where it throws std::invalid_argument, `explain` is called with that, and
/// throws what the caller shall see.
template <class Action, class Explain>
auto explained(const Action& action, const Explain& explain) {
#ifdef __wasi__
  const detail::Explaining waiting(explain);
  return action();
#else
  try {
    return action();
  } catch (const std::invalid_argument& refusal) {
    explain(refusal);
    throw;
  }
#endif
}

}  // namespace tumble
