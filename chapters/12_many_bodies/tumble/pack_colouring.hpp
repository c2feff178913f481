/// @file
/// Which packs of bodies several threads may visit at the same time, centres and tops together.
#pragma once

#include <tumble/packed_bodies.hpp>
#include <tumble/packed_index_set.hpp>

namespace tumble {

/// The packs of a group, in parts: the bodies of two packs of the same part have no pack of tops in
/// common, so threads may share out a part as they like.
//! [pack_colouring]
using PackColouring = std::vector<std::vector<std::uint32_t>>;

/// Each pack joins the first part in which nobody has its tops. If all bodies have tops, one part
/// is enough.
template <class Real, int width>
PackColouring pack_colouring(const PackedIndexSet<Real, width>& group,
                             const PackedBodies<Real, width>& bodies) {
  PackColouring parts;
  std::vector<std::vector<bool>> has_tops;  // of each part, for each pack of tops
  for_each_pack(group, 0, no_index, [&](std::uint32_t pack, const auto&) {
    std::vector<std::size_t> tops;
    const std::size_t first = std::size_t{pack} * width;
    for (std::size_t body = first; body < std::min(first + width, bodies.centres.size()); ++body)
      if (bodies.top_of[body] != no_index) tops.push_back(bodies.top_of[body] / width);
    std::size_t part = 0;
    const auto is_taken = [&](std::size_t top) { return has_tops[part][top]; };
    while (part < parts.size() && std::any_of(tops.begin(), tops.end(), is_taken)) ++part;
    if (part == parts.size()) {
      parts.emplace_back();
      has_tops.emplace_back(bodies.tops.packs().size());
    }
    parts[part].push_back(pack);
    for (const std::size_t top : tops) has_tops[part][top] = true;
  });
  return parts;
}
//! [pack_colouring]

}  // namespace tumble
