/// @file
/// Which bodies of which packs a pass visits.
#pragma once

#include <algorithm>
#include <tumble/pack.hpp>
#include <tumble/pass.hpp>

namespace tumble {

/// Packs from `begin` to before `end`, all of whose bodies are visited.
struct WholePacks {
  std::uint32_t begin, end;
};

/// A pack of whose bodies some are visited.
template <class Real, int width>
struct PartOfPack {
  std::uint32_t pack;
  PackMask<Real, width> members;
};

/// A Group sorted into packs, both lists in ascending order.
//! [pack_group]
template <class Real, int width>
struct PackGroup {
  std::vector<WholePacks> whole;
  std::vector<PartOfPack<Real, width>> parts;
};
//! [pack_group]

/// Sorts members of an array with `count` elements, or everyone, into packs. An empty lane at the
/// end may be visited too: it holds a body that nobody looks at.
template <class Real, int width>
PackGroup<Real, width> pack_group(bool everyone, std::vector<BodyIndex> members,
                                  std::size_t count) {
  PackGroup<Real, width> group;
  const auto pack_count = static_cast<std::uint32_t>((count + width - 1) / width);
  if (everyone && pack_count > 0) group.whole.push_back({0, pack_count});
  std::sort(members.begin(), members.end());
  for (auto member = members.begin(); member != members.end();) {
    const std::uint32_t pack = *member / width;
    PartOfPack<Real, width> part{pack, {}};
    int visited = 0;
    for (; member != members.end() && *member / width == pack; ++member, ++visited)
      part.members.lanes[*member % width] = -1;
    const std::size_t lanes = std::min<std::size_t>(width, count - std::size_t{pack} * width);
    if (static_cast<std::size_t>(visited) < lanes)
      group.parts.push_back(part);
    else if (!group.whole.empty() && group.whole.back().end == pack)
      ++group.whole.back().end;
    else
      group.whole.push_back({pack, pack + 1});
  }
  return group;
}

/// Calls `visit` with the beginning and the end of each row of packs, between `begin` and `end`,
/// all of whose bodies are members.
template <class Real, int width, class Visit>
void for_each_whole(const PackGroup<Real, width>& group, std::uint32_t begin, std::uint32_t end,
                    const Visit& visit) {
  auto run = std::partition_point(group.whole.begin(), group.whole.end(),
                                  [&](const WholePacks& packs) { return packs.end <= begin; });
  for (; run != group.whole.end() && run->begin < end; ++run)
    visit(std::max(run->begin, begin), std::min(run->end, end));
}

/// Calls `visit` with each other pack that has members, and with them.
template <class Real, int width, class Visit>
void for_each_part(const PackGroup<Real, width>& group, std::uint32_t begin, std::uint32_t end,
                   const Visit& visit) {
  auto part = std::partition_point(group.parts.begin(), group.parts.end(),
                                   [&](const auto& candidate) { return candidate.pack < begin; });
  for (; part != group.parts.end() && part->pack < end; ++part) visit(part->pack, part->members);
}

}  // namespace tumble
