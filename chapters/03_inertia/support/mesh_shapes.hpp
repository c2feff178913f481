/// @file
/// Meshes of shapes whose mass properties are known otherwise.
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <tumble/mesh.hpp>

namespace tumble::support {

template <class Real>
Mesh<Real> box_mesh(const Vec3<Real>& size) {
  Mesh<Real> mesh;
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7})
    mesh.vertices.push_back(size.cwiseProduct(
        Vec3<Real>(Real(corner & 1), Real(corner >> 1 & 1), Real(corner >> 2 & 1)) -
        Vec3<Real>::Constant(Real(0.5))));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// An octahedron whose triangles are cut in four `cuts` times, the new corners pushed out to the
/// sphere.
template <class Real>
Mesh<Real> sphere_mesh(Real radius, int cuts) {
  Mesh<Real> mesh{
      {{radius, 0, 0},
       {-radius, 0, 0},
       {0, radius, 0},
       {0, -radius, 0},
       {0, 0, radius},
       {0, 0, -radius}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int cut = 0; cut < cuts; ++cut) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t i, std::size_t j) {
      const auto [place, fresh] = middles.try_emplace(std::minmax(i, j), mesh.vertices.size());
      if (fresh) {
        const Vec3<Real> sum = mesh.vertices[i] + mesh.vertices[j];
        mesh.vertices.push_back(sum * (radius / sum.norm()));
      }
      return place->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for (const auto& [i, j, k] : mesh.triangles) {
      const std::size_t ij = middle(i, j), jk = middle(j, k), ki = middle(k, i);
      finer.insert(finer.end(), {{i, ij, ki}, {ij, j, jk}, {ki, jk, k}, {ij, jk, ki}});
    }
    mesh.triangles = finer;
  }
  return mesh;
}

/// A prism along z with the given outline, anticlockwise and seen whole from its first corner; the
/// top is shrunk by `taper`, 1 for none.
template <class Real>
Mesh<Real> prism_mesh(const std::vector<Vec3<Real>>& outline, Real bottom, Real top,
                      Real taper = 1) {
  Mesh<Real> mesh;
  const std::size_t n = outline.size();
  for (const Vec3<Real>& corner : outline)
    mesh.vertices.push_back({corner.x(), corner.y(), bottom});
  for (const Vec3<Real>& corner : outline)
    mesh.vertices.push_back({corner.x() * taper, corner.y() * taper, top});
  for (std::size_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({n, n + i, n + i + 1});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  return mesh;
}

/// `count` corners on the arc from one angle to another, both ends included.
template <class Real>
std::vector<Vec3<Real>> arc(Real radius, Real from, Real to, int count) {
  std::vector<Vec3<Real>> corners;
  for (int i = 0; i < count; ++i) {
    const Real angle = from + (to - from) * Real(i) / Real(count - 1);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return corners;
}

}  // namespace tumble::support
