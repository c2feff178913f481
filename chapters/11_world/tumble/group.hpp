/// @file
/// Which bodies an effect visits: a set that changes in constant time.
#pragma once

#include <tumble/terms.hpp>

namespace tumble {

/// A set of array elements. As long as it holds the first so many of them, which is what an effect
/// for everyone visits, it is a number alone; else a list in no order.
//! [group]
class Group {
 public:
  std::size_t size() const { return is_listed_ ? members_.size() : first_; }
  bool empty() const { return size() == 0; }
  bool contains(BodyIndex i) const {
    return is_listed_ ? i < place_.size() && place_[i] != no_index : i < first_;
  }

  void insert(BodyIndex i) {
    if (contains(i)) return;
    if (!is_listed_ && i == first_) {
      ++first_;
      return;
    }
    list();
    if (place_.size() <= i) place_.resize(i + std::size_t{1}, no_index);
    place_[i] = static_cast<BodyIndex>(members_.size());
    members_.push_back(i);
  }

  void erase(BodyIndex i) {
    if (!contains(i)) return;
    if (!is_listed_ && i + std::size_t{1} == first_) {
      --first_;
      return;
    }
    list();
    const BodyIndex last = members_.back();
    members_[place_[i]] = last;
    place_[last] = place_[i];
    place_[i] = no_index;
    members_.pop_back();
  }

  void set(BodyIndex i, bool is_member) { is_member ? insert(i) : erase(i); }

  /// Element `last` of the array gets place `i`, whose element goes.
  void replace_by_last(BodyIndex i, BodyIndex last) {
    const bool is_member = contains(last);
    erase(last);
    if (i != last) set(i, is_member);
  }

  /// Calls `visit` with the index of each member.
  template <class Visit>
  void for_each(const Visit& visit) const {
    if (is_listed_)
      for (const BodyIndex i : members_) visit(i);
    else
      for (BodyIndex i = 0; i < first_; ++i) visit(i);
  }
  //! [group]

  /// The first so many, if they are all; nothing else tells a list from a number.
  bool is_listed() const { return is_listed_; }

 private:
  void list() {
    if (is_listed_) return;
    is_listed_ = true;
    place_.resize(first_);
    members_.resize(first_);
    for (BodyIndex i = 0; i < first_; ++i) place_[i] = members_[i] = i;
  }

  bool is_listed_ = false;
  std::size_t first_ = 0;
  std::vector<BodyIndex> members_, place_;
};

/// Calls `change` with each element of `array` that the group names.
template <class Element, class Change>
void for_each_of(const Group& group, std::vector<Element>& array, const Change& change) {
  group.for_each([&](BodyIndex i) { change(array[i]); });
}

/// Whom an effect visits: centres, or tops for an effect that sees tops, or pairs.
struct Visits {
  Group group = {};
  std::vector<BodyPair> pairs = {};
  std::size_t size() const { return group.size() + pairs.size(); }
};

}  // namespace tumble
