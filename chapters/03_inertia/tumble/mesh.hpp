/// @file
/// A closed surface of triangles, and what is wrong with one that isn't.
#pragma once

#include <algorithm>
#include <array>
#include <tumble/require.hpp>
#include <vector>

namespace tumble {

/// A body given by its skin. Seen from outside, the three corners of each triangle run
/// anticlockwise, so that (b − a) × (c − a) points out.
template <class Real>
struct Mesh {
  std::vector<Vec3<Real>> vertices;                   ///< m, model axes
  std::vector<std::array<std::size_t, 3>> triangles;  ///< each three numbers of vertices, from 0
};

/// One side of one triangle.
struct MeshEdge {
  std::size_t low;       ///< the vertex with the smaller number
  std::size_t high;      ///< and the other one
  std::size_t triangle;  ///< whose side it is
  bool upward;           ///< true if the triangle runs from low to high
};

/// Throws unless every vertex is finite and every triangle has three corners that exist and some
/// area: twice it is more than 8 roundings make of the square of its longest side.
template <class Real>
void require_sound_triangles(const Mesh<Real>& mesh) {
  if (mesh.triangles.empty()) throw std::invalid_argument("the mesh has no triangles");
  const std::size_t count = mesh.vertices.size();
  for (std::size_t v = 0; v < count; ++v)
    require_finite("vertex " + std::to_string(v), mesh.vertices[v], "m");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::string name = "triangle " + std::to_string(t);
    for (const std::size_t corner : mesh.triangles[t])
      if (corner >= count)
        throw std::invalid_argument(name + " names vertex " + std::to_string(corner) +
                                    "; the mesh has " + std::to_string(count) +
                                    " vertices, numbered from 0");
    const auto [i, j, k] = mesh.triangles[t];
    const Vec3<Real> ab = mesh.vertices[j] - mesh.vertices[i];
    const Vec3<Real> ac = mesh.vertices[k] - mesh.vertices[i];
    const Real longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    const Real slack = 8 * (std::numeric_limits<Real>::epsilon() / 2);
    if (!((ab / longest).cross(ac / longest).norm() > slack))
      throw std::invalid_argument(name + " has no area: its corners " + text_of(mesh.vertices[i]) +
                                  ", " + text_of(mesh.vertices[j]) + " and " +
                                  text_of(mesh.vertices[k]) + " m lie on one line");
  }
}

/// All sides of all triangles; those between the same two vertices stand next to each other.
template <class Real>
std::vector<MeshEdge> sorted_edges(const Mesh<Real>& mesh) {
  std::vector<MeshEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t side = 0; side < 3; ++side) {
      const std::size_t from = mesh.triangles[t][side], to = mesh.triangles[t][(side + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  std::sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b) {
    return std::array{a.low, a.high, a.triangle} < std::array{b.low, b.high, b.triangle};
  });
  return edges;
}

/// Throws unless the triangles close up: each side is shared by exactly two triangles, which run
/// along it in opposite directions. Several separate surfaces are allowed, and so is a cavity,
/// whose triangles face into the hollow.
template <class Real>
void require_closed(const Mesh<Real>& mesh) {
  require_sound_triangles(mesh);
  const std::vector<MeshEdge> edges = sorted_edges(mesh);
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next) {
    const MeshEdge& edge = edges[first];
    while (next < edges.size() && edges[next].low == edge.low && edges[next].high == edge.high)
      ++next;
    const std::string name = "the edge from vertex " + std::to_string(edge.low) + " to vertex " +
                             std::to_string(edge.high) + " belongs to ";
    const std::string triangle = std::to_string(edge.triangle);
    if (next - first == 1)
      throw std::invalid_argument(name + "triangle " + triangle +
                                  " alone; the mesh is open there: close the hole, or merge "
                                  "vertices that lie in the same place");
    if (next - first > 2)
      throw std::invalid_argument(name + std::to_string(next - first) +
                                  " triangles; each edge of a solid's skin joins exactly two");
    if (edge.upward == edges[first + 1].upward)
      throw std::invalid_argument(name + "triangles " + triangle + " and " +
                                  std::to_string(edges[first + 1].triangle) +
                                  ", and both run along it in the same direction; turn one of "
                                  "them round");
  }
}

}  // namespace tumble
