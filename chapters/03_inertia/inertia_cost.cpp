#include <benchmark/benchmark.h>

#include <support/mesh_shapes.hpp>
#include <tumble/mesh_mass_properties.hpp>
#include <tumble/spheres.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;

namespace {

void box(benchmark::State& state) {
  Box<double> solid{{1, 2, 3}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(solid);
    benchmark::DoNotOptimize(mass_properties(solid, 2));
  }
}

void slanted(benchmark::State& state, auto function) {
  const Mat3d R = Eigen::AngleAxisd(0.7, Vec3d(1, 2, 3).normalized()).toRotationMatrix();
  Mat3d inertia = in_other_axes(mass_properties(Box<double>{{1, 2, 3}}, 2).inertia, R);
  for (auto _ : state) {
    benchmark::DoNotOptimize(inertia);
    benchmark::DoNotOptimize(function(inertia));
  }
}

void sphere_mesh(benchmark::State& state) {
  const Mesh<double> mesh = support::sphere_mesh(1.0, 3);
  for (auto _ : state) benchmark::DoNotOptimize(mass_properties(mesh, 2));
}

}  // namespace

BENCHMARK(box)->Name("mass properties of a box");
BENCHMARK_CAPTURE(slanted, axes, [](const Mat3d& inertia) {
  return principal_axes(inertia);
})->Name("principal axes of a slanted tensor");
BENCHMARK_CAPTURE(slanted, inverse, [](const Mat3d& inertia) {
  return inverse_inertia("body", inertia);
})->Name("inverse of a slanted tensor, checked");
BENCHMARK(sphere_mesh)->Name("mass properties of a mesh of 512 triangles, checked");
