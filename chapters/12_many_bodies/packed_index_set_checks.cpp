#include <numeric>
#include <support/checks.hpp>
#include <support/random_generator.hpp>
#include <tumble/packed_visits.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// The first so many come in order, and the group keeps their number; others come as the dice want,
/// and it keeps a list.
IndexSet group_of(const std::vector<bool>& is_member, RandomGenerator& dice) {
  std::vector<BodyIndex> members;
  for (BodyIndex body = 0; body < is_member.size(); ++body)
    if (is_member[body])
      members.insert(members.begin() + static_cast<std::ptrdiff_t>(dice.below(members.size() + 1)),
                     body);
  if (std::is_sorted(is_member.begin(), is_member.end(), std::greater<>()))
    std::sort(members.begin(), members.end());
  IndexSet group;
  for (const BodyIndex member : members) group.insert(member);
  return group;
}

/// Compares what is known of a group in packs with what is counted body by body.
template <int width>
void check_group(const std::vector<bool>& is_member, RandomGenerator& dice) {
  const IndexSet group = group_of(is_member, dice);
  const auto packs = packed_index_set<double, width>(group);
  const auto count = static_cast<std::uint32_t>(is_member.size() / width);
  std::vector<int> members(count, 0);
  for (std::size_t body = 0; body < is_member.size(); ++body)
    members[body / width] += is_member[body];
  REQUIRE(count_of(packs) == group.size());

  // Rows of whole packs as long as can be, and each other pack with its members.
  std::size_t rows = 0, parts = 0;
  for (std::uint32_t pack = 0; pack < count; ++pack) {
    if (members[pack] == width) {
      if (pack == 0 || members[pack - 1] < width) ++rows;
      REQUIRE(rows <= packs.whole.size());
      REQUIRE(packs.whole[rows - 1].begin <= pack);
      REQUIRE(packs.whole[rows - 1].end > pack);
    } else if (members[pack] > 0) {
      REQUIRE(parts < packs.parts.size());
      const auto& part = packs.parts[parts++];
      REQUIRE(part.pack == pack);
      for (std::uint32_t lane = 0; lane < width; ++lane)
        REQUIRE(part.members.lanes[lane] == (is_member[pack * width + lane] ? -1 : 0));
    }
  }
  REQUIRE(packs.whole.size() == rows);
  REQUIRE(packs.parts.size() == parts);

  for (std::uint32_t begin = 0; begin <= count; ++begin)
    for (std::uint32_t end = begin + 1; end <= count + 1; ++end) {
      std::vector<int> visited(count, 0);
      for_each_whole(packs, begin, end, [&](std::uint32_t first, std::uint32_t last) {
        REQUIRE(first < last);
        for (std::uint32_t pack = first; pack < last; ++pack) visited[pack] = width;
      });
      for_each_part(packs, begin, end, [&](std::uint32_t pack, const auto& part) {
        for (int lane = 0; lane < width; ++lane) visited[pack] += part[lane];
      });
      for (std::uint32_t pack = 0; pack < count; ++pack)
        REQUIRE(visited[pack] == (begin <= pack && pack < end ? members[pack] : 0));
    }
}

template <int width>
void check_groups() {
  RandomGenerator dice(53);
  for (std::size_t first = 0; first <= std::size_t{4} * width; ++first) {  // the first so many
    std::vector<bool> is_member(std::size_t{5} * width, false);
    std::fill_n(is_member.begin(), first, true);
    check_group<width>(is_member, dice);
  }
  for (int n = 0; n < 60; ++n) {  // packs with all, none or some of their bodies
    std::vector<bool> is_member(std::size_t{6} * width);
    for (std::size_t pack = 0; pack < 6; ++pack) {
      const std::size_t kind = dice.below(3);
      for (std::size_t body = pack * width; body < (pack + 1) * width; ++body)
        is_member[body] = kind == 0 || (kind == 1 && dice.one_in(2));
    }
    check_group<width>(is_member, dice);
  }
}

}  // namespace

TEST_CASE("A group sorted into packs has the members that it had, in whole packs where it can") {
  check_groups<2>();
  check_groups<4>();
  check_groups<8>();
}

TEST_CASE_TEMPLATE("The tops of a pack's bodies are their own, in whatever order they lie", Real,
                   EVERY_PRECISION) {
  constexpr int width = 2;
  PackedBodies<Real, width> bodies;
  std::array<BodyIndex, 5> tops;
  std::iota(tops.begin(), tops.end(), 0);
  for (const BodyIndex top : tops) {
    bodies.centres.push_back({});
    bodies.tops.push_back({.angular_momentum_body = {Real(top + 1), 0, 0}});
  }
  do {
    bodies.top_of.assign(tops.begin(), tops.end());
    for (BodyIndex& top : bodies.top_of)
      if (top == 4) top = no_index;  // a point
    for (BodyIndex body = 0; body < tops.size(); ++body) {
      const BodyIndex top = bodies.top_of[body];
      REQUIRE(tops_of(bodies, body / width).angular_momentum_body.x()[body % width] ==
              (top == no_index ? 0 : Real(top + 1)));
    }
  } while (std::next_permutation(tops.begin(), tops.end()));
}
