/// @file
/// Handles: names for bodies that stay right while other bodies come and go.
#pragma once

#include <atomic>
#include <compare>
#include <stdexcept>
#include <string>
#include <tumble/bodies.hpp>

namespace tumble {

/// A body of a world. The generation tells a body from one that had its slot before, and the family
/// tells its world, and the copies of that, from others. A handle that no world gave out has
/// generation 0, which is nobody's. Handles have an order, so that a std::map can keep what a user
/// has to remember of each body.
struct BodyHandle {
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  std::uint64_t family = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): the 0 that it means is the compiler's
  friend auto operator<=>(const BodyHandle&, const BodyHandle&) = default;
};

/// An effect of a world.
struct EffectHandle {
  std::uint64_t number = 0;
  std::uint64_t family = 0;
  friend auto operator<=>(const EffectHandle&, const EffectHandle&) = default;
};

/// Which body has which place in the arrays.
class Slots {
 public:
  /// The generation of the first body in each slot is `first`, at least 1.
  explicit Slots(std::uint32_t first = 1) : first_(first) {}

  /// A handle for the body that is appended at `index`.
  BodyHandle take(BodyIndex index) {
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
      slots_.push_back({no_index, first_});
    }
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    slots_[slot].index = index;
    slot_of_.push_back(slot);
    arrangement_ = next_number();
    return {slot, slots_[slot].generation, family_};
  }

  /// Forgets a body; the last one moves to its place, as in take_out(). A slot whose generations
  /// are used up is not used again, or an old handle would name a new body.
  void release(BodyHandle body) {
    Slot& slot = slots_[body.slot];
    slot_of_[slot.index] = slot_of_.back();
    slots_[slot_of_.back()].index = slot.index;
    slot_of_.pop_back();
    slot.index = no_index;
    arrangement_ = next_number();
    if (++slot.generation != 0) free_.push_back(body.slot);
  }

  bool contains(BodyHandle body) const {
    return body.family == family_ && body.slot < slots_.size() &&
           slots_[body.slot].generation == body.generation && slots_[body.slot].index != no_index;
  }

  /// What the handles of this world, and of its copies, have in common.
  std::uint64_t family() const { return family_; }
  /// Another number after each body that came or went. Two worlds have the same one only if each is
  /// a copy of the other, or both of a third, and no body has come or gone since.
  std::uint64_t arrangement() const { return arrangement_; }

  /// @throws std::out_of_range if the handle is stale, or another world's, or nobody's.
  BodyIndex index_of(BodyHandle body) const {
    if (body.generation == 0)
      throw std::out_of_range("empty handle: no world gave it out; add() and find() do");
    if (body.family != family_)
      throw std::out_of_range("foreign handle: body " + std::to_string(body.slot) +
                              " is one of another world");
    if (!contains(body))
      throw std::out_of_range("stale handle: body " + std::to_string(body.slot) + ", generation " +
                              std::to_string(body.generation) + ", has been removed");
    return slots_[body.slot].index;
  }

  BodyHandle handle_of(BodyIndex index) const {
    return {slot_of_[index], slots_[slot_of_[index]].generation, family_};
  }

 private:
  struct Slot {
    BodyIndex index;
    std::uint32_t generation;
  };
  static std::uint64_t next_number() {
    static std::atomic<std::uint64_t> numbers = 0;
    return ++numbers;
  }
  std::uint64_t family_ = next_number(), arrangement_ = family_;
  std::uint32_t first_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> slot_of_;  // for each array element
  std::vector<std::uint32_t> free_;
};

}  // namespace tumble
