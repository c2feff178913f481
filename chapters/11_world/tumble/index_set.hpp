/// @file
/// Which bodies an effect visits: a set that changes in constant time, on average.
#pragma once

#include <algorithm>
#include <tumble/terms.hpp>

namespace tumble {

/// A set of array elements. It is a number n alone, for the elements 0 to n − 1, which is what an
/// effect for everyone visits, until it holds others for the first time; then a list in no order.
//! [index_set]
class IndexSet {
 public:
  std::size_t size() const { return is_listed_ ? members_.size() : first_; }
  bool empty() const { return size() == 0; }
  bool contains(BodyIndex i) const {
    return is_listed_ ? place_of(i) < members_.size() : i < first_;
  }

  void insert(BodyIndex i) {
    if (contains(i)) return;
    if (!is_listed_ && i == first_) {
      ++first_;
      return;
    }
    list();
    members_.push_back(i);
    if (!places_.empty() || members_.size() > short_list) note_place(i, members_.size() - 1);
  }

  void erase(BodyIndex i) {
    if (!contains(i)) return;
    if (!is_listed_ && i + std::size_t{1} == first_) {
      --first_;
      return;
    }
    list();
    const std::size_t place = place_of(i);
    members_[place] = members_.back();
    if (!places_.empty()) {
      places_[members_.back()] = static_cast<BodyIndex>(place);
      places_[i] = no_index;
    }
    members_.pop_back();
  }

  void set(BodyIndex i, bool is_member) { is_member ? insert(i) : erase(i); }

  /// Element `last` of the array gets place `i`, whose element goes.
  void replace_by_last(BodyIndex i, BodyIndex last) {
    const bool is_member = contains(last);
    erase(last);
    if (i != last) set(i, is_member);
  }

  class Iterator {
   public:
    Iterator(const BodyIndex* list, std::size_t place) : list_(list), place_(place) {}
    BodyIndex operator*() const { return list_ ? list_[place_] : static_cast<BodyIndex>(place_); }
    Iterator& operator++() {
      ++place_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return place_ == other.place_; }

   private:
    const BodyIndex* list_;
    std::size_t place_;
  };
  Iterator begin() const { return {is_listed_ ? members_.data() : nullptr, 0}; }
  Iterator end() const { return {nullptr, size()}; }
  //! [index_set]

  /// True if it is a list; else it holds 0 to size() − 1.
  bool is_listed() const { return is_listed_; }

 private:
  /// A list of so many is searched; a longer one knows the place of each member.
  static constexpr std::size_t short_list = 32;

  std::size_t place_of(BodyIndex i) const {
    if (!places_.empty()) return i < places_.size() ? places_[i] : no_index;
    const auto found = std::find(members_.begin(), members_.end(), i);
    return static_cast<std::size_t>(found - members_.begin());
  }

  void note_place(BodyIndex i, std::size_t place) {
    if (places_.empty())
      for (std::size_t k = 0; k < place; ++k) grow_to(members_[k]) = static_cast<BodyIndex>(k);
    grow_to(i) = static_cast<BodyIndex>(place);
  }
  BodyIndex& grow_to(BodyIndex i) {
    if (places_.size() <= i) places_.resize(i + std::size_t{1}, no_index);
    return places_[i];
  }

  void list() {
    if (is_listed_) return;
    is_listed_ = true;
    for (BodyIndex i = 0; i < first_; ++i) members_.push_back(i);
    if (first_ > short_list) places_ = members_;
  }

  bool is_listed_ = false;
  std::size_t first_ = 0;
  std::vector<BodyIndex> members_, places_;
};

/// What an effect visits: centres, or tops if it sees tops, or pairs. Of one that finds its pairs:
/// the bodies that it calls for.
struct Members {
  IndexSet indices = {};
  std::vector<BodyPair> pairs = {};
  std::size_t size() const { return indices.size() + pairs.size(); }
};

}  // namespace tumble
