/// @file
/// The numbers and vectors that every chapter computes with.
#pragma once

#if __cplusplus < 202002L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
// There is no such file, at which a compiler stops; after an #error it would go on.
#include "Tumble is written in C++20: compile with -std=c++20"
#endif

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "Tumble's results hold for exact IEEE rounding: compile without -ffast-math and -Ofast."
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <type_traits>

/// Everything that the course teaches and a program may use.
namespace tumble {

/// Three numbers in a column: a position, a velocity, a force. The doc of each use says in which
/// frame and unit.
///
/// `Real` stands for the kind of number: `float`, `double` or `long double`. A function written for
/// `Real` is compiled once for each kind that a program asks for, so precision is chosen in one
/// place and the physics is written once.
//! [vectors]
template <class Real>
using Vec3 = Eigen::Matrix<Real, 3, 1>;
//! [vectors]

/// Three rows of three numbers, such as an inertia tensor or a change of axes. It acts on a column
/// from the left.
template <class Real>
using Mat3 = Eigen::Matrix<Real, 3, 3>;

/// The scalar product a · b of two vectors, the last two of its three products being added first.
/// Eigen has one too, but the order in which that adds, and so its last bit, is another from one
/// version to the next.
template <class A, class B>
typename A::Scalar dot(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  const auto& u = a.eval();
  const auto& v = b.eval();
  return u[0] * v[0] + (u[1] * v[1] + u[2] * v[2]);
}

/// `Real` itself, in a place where the compiler must not guess it. One argument of a function
/// decides which `Real` is meant; the others are written with `Same<Real>` and take whatever
/// converts to it, a sum of vectors for example.
template <class Real>
using Same = std::type_identity_t<Real>;

//! [aliases]
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;
//! [aliases]
using Mat3f = Mat3<float>;
using Mat3d = Mat3<double>;

/// `if_true` or `if_false`: a choice between two values that are both computed. Loops that run on
/// many bodies at once choose in this way, body by body, where an `if` would have to choose once
/// for all of them.
template <class Real>
Real select(bool condition, Real if_true, Same<Real> if_false) {
  return condition ? if_true : if_false;
}

}  // namespace tumble
