/// @file
/// The names and handles of a world's bodies.
#pragma once

#include <stdexcept>
#include <string>
#include <tumble/handles.hpp>
#include <unordered_map>

namespace tumble {

/// Which name and which handle belong to which place in the arrays. What lies there it does not
/// know: see BodyStore.
class BodyRegistry {
 public:
  std::size_t size() const { return names_.size(); }
  bool contains(BodyHandle body) const { return slots_.contains(body); }
  /// @throws std::out_of_range if the handle is stale, or another world's, or nobody's.
  BodyIndex index_of(BodyHandle body) const { return slots_.index_of(body); }
  BodyHandle handle_at(BodyIndex index) const { return slots_.handle_of(index); }
  /// Of a body that was given none, "body 7", after its slot.
  std::string name_of(BodyIndex index) const {
    return names_[index].empty() ? "body " + std::to_string(handle_at(index).slot) : names_[index];
  }
  std::uint64_t family() const { return slots_.family(); }
  std::uint64_t arrangement() const { return slots_.arrangement(); }

  /// @throws std::invalid_argument if no body has that name.
  BodyHandle find(const std::string& name) const {
    const auto found = handles_.find(name);
    if (found == handles_.end()) throw std::invalid_argument("no body is called '" + name + "'");
    return found->second;
  }

  /// @throws std::invalid_argument unless a body that comes can have this name.
  void require_free(const std::string& name) const {
    if (name.empty()) throw std::invalid_argument("a body needs a name");
    if (handles_.contains(name))
      throw std::invalid_argument("two bodies are called '" + name + "'; names must differ");
  }

  /// A body comes, behind all others; with an empty name it can't be found by one.
  BodyHandle append(const std::string& name) {
    const BodyHandle handle = slots_.take(static_cast<BodyIndex>(names_.size()));
    names_.push_back(name);
    if (!name.empty()) handles_.emplace(name, handle);
    return handle;
  }

  /// A body goes; the last one gets its place.
  void take_out(BodyHandle body) {
    const BodyIndex index = index_of(body);
    handles_.erase(names_[index]);
    slots_.release(body);
    swap_and_pop(names_, index);
  }

 private:
  std::vector<std::string> names_;  // in the order of the bodies
  std::unordered_map<std::string, BodyHandle> handles_;
  Slots slots_;
};

}  // namespace tumble
