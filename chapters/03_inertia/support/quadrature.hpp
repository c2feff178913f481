/// @file
/// The mass properties of a solid by adding up small pieces, without any formula of the chapter.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <tumble/mass_properties.hpp>
#include <vector>

namespace tumble::support {

/// A piece of a solid: where it is, and how much of the volume (or area, or length) it stands for.
struct Piece {
  Vec3<long double> position;
  long double weight;
};

struct Node {
  long double at, weight;
};

/// Gauss and Legendre's four points on 0 … 1: exact for polynomials up to degree 7.
inline std::array<Node, 4> gauss_legendre() {
  const long double inner = std::sqrt(3.0L / 7 - 2.0L / 7 * std::sqrt(6.0L / 5));
  const long double outer = std::sqrt(3.0L / 7 + 2.0L / 7 * std::sqrt(6.0L / 5));
  const long double heavy = (18 + std::sqrt(30.0L)) / 72, light = (18 - std::sqrt(30.0L)) / 72;
  return {Node{(1 - outer) / 2, light}, Node{(1 - inner) / 2, heavy}, Node{(1 + inner) / 2, heavy},
          Node{(1 + outer) / 2, light}};
}

/// Eight equal steps around a circle: exact for sines and cosines of up to seven times the angle.
inline std::array<Node, 8> around() {
  std::array<Node, 8> nodes;
  for (std::size_t i = 0; i < 8; ++i) nodes[i] = {(static_cast<long double>(i) + 0.5L) / 8, 0.125L};
  return nodes;
}

/// Cuts the cube 0 … 1 into pieces and maps each; `map(u, v, w)` gives a piece whose weight is the
/// volume that a unit of u, v and w becomes.
template <class Nodes, class Map>
std::vector<Piece> pieces_of(const Nodes& third, const Map& map) {
  std::vector<Piece> pieces;
  for (const Node& u : gauss_legendre())
    for (const Node& v : gauss_legendre())
      for (const Node& w : third) {
        Piece piece = map(u.at, v.at, w.at);
        piece.weight *= u.weight * v.weight * w.weight;
        pieces.push_back(piece);
      }
  return pieces;
}

/// What lies between two distances from the centre and two values of the cosine of the angle from
/// the z axis, then stretched.
inline std::vector<Piece> ball_pieces(long double from, long double to, long double low,
                                      long double high, const Vec3<long double>& stretch) {
  return pieces_of(around(), [&](long double u, long double v, long double w) {
    const long double r = from + u * (to - from), cosine = low + v * (high - low);
    const long double sine = std::sqrt(1 - cosine * cosine);
    const long double angle = 2 * std::numbers::pi_v<long double> * w;
    const Vec3<long double> unit(sine * std::cos(angle), sine * std::sin(angle), cosine);
    return Piece{
        r * unit.cwiseProduct(stretch),
        r * r * (to - from) * (high - low) * 2 * std::numbers::pi_v<long double> * stretch.prod()};
  });
}

/// A solid of revolution about z whose radius changes evenly from one end to the other.
inline std::vector<Piece> turned_pieces(long double bottom, long double top,
                                        long double bottom_radius, long double top_radius) {
  return pieces_of(around(), [&](long double u, long double v, long double w) {
    const long double radius = bottom_radius + u * (top_radius - bottom_radius);
    const long double angle = 2 * std::numbers::pi_v<long double> * w;
    return Piece{
        {v * radius * std::cos(angle), v * radius * std::sin(angle), bottom + u * (top - bottom)},
        v * radius * radius * (top - bottom) * 2 * std::numbers::pi_v<long double>};
  });
}

inline std::vector<Piece> box_pieces(const Vec3<long double>& size) {
  return pieces_of(gauss_legendre(), [&](long double u, long double v, long double w) {
    return Piece{size.cwiseProduct(Vec3<long double>(u, v, w) - Vec3<long double>::Constant(0.5L)),
                 size.prod()};
  });
}

/// A cube folded into a tetrahedron.
inline std::vector<Piece> tetrahedron_pieces(const std::array<Vec3<long double>, 4>& corners) {
  const Vec3<long double>&a = corners[0], &b = corners[1], &c = corners[2], &d = corners[3];
  const long double box = std::abs((b - a).dot((c - a).cross(d - a)));
  return pieces_of(gauss_legendre(), [&](long double u, long double v, long double w) {
    return Piece{a + u * ((b - a) + v * ((c - b) + w * (d - c))), box * u * u * v};
  });
}

/// Volume (or area, or length), and the mass properties for 1 kg, from the definitions.
struct Summed {
  long double volume = 0;
  MassProperties<long double> body;
};

inline Summed summed(const std::vector<Piece>& pieces) {
  Summed result;
  Vec3<long double> first = Vec3<long double>::Zero();
  for (const Piece& piece : pieces) {
    result.volume += piece.weight;
    first += piece.weight * piece.position;
  }
  result.body.mass = 1;
  result.body.centre_of_mass = first / result.volume;
  for (const Piece& piece : pieces) {
    const Vec3<long double> r = piece.position - result.body.centre_of_mass;
    const Mat3<long double> squares =
        r.squaredNorm() * Mat3<long double>::Identity() - r * r.transpose();
    result.body.inertia += piece.weight / result.volume * squares;
  }
  return result;
}

}  // namespace tumble::support
