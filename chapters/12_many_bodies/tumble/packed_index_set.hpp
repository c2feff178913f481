/// @file
/// Which bodies of which packs a pass visits.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tumble/index_set.hpp>
#include <tumble/pack.hpp>

namespace tumble {

/// Packs from `begin` to before `end`, all of whose bodies are visited.
struct WholePacks {
  std::uint32_t begin, end;
};

/// A pack in which some bodies are visited and others not.
template <class Real, int width>
struct PartOfPack {
  std::uint32_t pack;
  PackMask<Real, width> members;
};

/// An IndexSet sorted into packs, both lists in ascending order.
template <class Real, int width>
struct PackedIndexSet {
  std::vector<WholePacks> whole;
  std::vector<PartOfPack<Real, width>> parts;
};

namespace detail {

/// The members of a set in ascending order. A bit for each body is faster than to sort a list.
inline std::vector<BodyIndex> sorted_members(const IndexSet& members) {
  std::vector<std::uint64_t> bits;
  for (const BodyIndex i : members) {
    if (i / 64 >= bits.size()) bits.resize(i / 64 + 1);
    bits[i / 64] |= std::uint64_t{1} << i % 64;
  }
  std::vector<BodyIndex> sorted;
  sorted.reserve(members.size());
  for (std::size_t n = 0; n < bits.size(); ++n)
    for (std::uint64_t left = bits[n]; left != 0; left &= left - 1)
      sorted.push_back(static_cast<BodyIndex>(n * 64) +
                       static_cast<BodyIndex>(std::countr_zero(left)));
  return sorted;
}

}  // namespace detail

/// Sorts the members of a set into packs. The lanes that are left over in the last pack belong to
/// nobody and are not visited.
template <class Real, int width>
PackedIndexSet<Real, width> packed_index_set(const IndexSet& members) {
  PackedIndexSet<Real, width> indices;
  const auto add = [&](std::uint32_t pack, const PackMask<Real, width>& part, int visited) {
    if (visited < width)
      indices.parts.push_back({pack, part});
    else if (!indices.whole.empty() && indices.whole.back().end == pack)
      ++indices.whole.back().end;
    else
      indices.whole.push_back({pack, pack + 1});
  };
  std::vector<BodyIndex> sorted;
  std::size_t first = 0;
  if (members.is_listed()) {
    sorted = detail::sorted_members(members);
  } else if (!members.empty()) {
    first = members.size() / width * width;
    if (first > 0) indices.whole.push_back({0, static_cast<std::uint32_t>(first / width)});
    for (; first < members.size(); ++first) sorted.push_back(static_cast<BodyIndex>(first));
  }
  for (auto member = sorted.begin(); member != sorted.end();) {
    const std::uint32_t pack = *member / width;
    PackMask<Real, width> part{};
    int visited = 0;
    for (; member != sorted.end() && *member / width == pack; ++member, ++visited)
      part.lanes[*member % width] = -1;
    add(pack, part, visited);
  }
  return indices;
}

/// How many members there are.
template <class Real, int width>
std::size_t count_of(const PackedIndexSet<Real, width>& indices) {
  std::size_t count = 0;
  for (const WholePacks& packs : indices.whole)
    count += std::size_t{packs.end - packs.begin} * width;
  for (const auto& part : indices.parts)
    for (int lane = 0; lane < width; ++lane) count += part.members[lane];
  return count;
}

/// Calls `visit` with the beginning and the end of each row of packs, between `begin` and `end`,
/// all of whose bodies are members.
template <class Real, int width, class Visit>
void for_each_whole(const PackedIndexSet<Real, width>& indices, std::uint32_t begin,
                    std::uint32_t end, const Visit& visit) {
  auto run = std::partition_point(indices.whole.begin(), indices.whole.end(),
                                  [&](const WholePacks& packs) { return packs.end <= begin; });
  for (; run != indices.whole.end() && run->begin < end; ++run)
    visit(std::max(run->begin, begin), std::min(run->end, end));
}

/// Calls `visit` with each pack between `begin` and `end` of which only some bodies are members,
/// and with their mask.
template <class Real, int width, class Visit>
void for_each_part(const PackedIndexSet<Real, width>& indices, std::uint32_t begin,
                   std::uint32_t end, const Visit& visit) {
  auto part = std::partition_point(indices.parts.begin(), indices.parts.end(),
                                   [&](const auto& candidate) { return candidate.pack < begin; });
  for (; part != indices.parts.end() && part->pack < end; ++part) visit(part->pack, part->members);
}

/// Calls `visit` with each pack between `begin` and `end` that has members, and with their mask.
template <class Real, int width, class Visit>
void for_each_pack(const PackedIndexSet<Real, width>& indices, std::uint32_t begin,
                   std::uint32_t end, const Visit& visit) {
  constexpr PackMask<Real, width> all{~typename PackMask<Real, width>::Lanes{}};
  for_each_whole(indices, begin, end, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t pack = first; pack < last; ++pack) visit(pack, all);
  });
  for_each_part(indices, begin, end, visit);
}

}  // namespace tumble
