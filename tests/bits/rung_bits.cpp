// Turns a top by every rung in both precisions, and prints a digest of all states: the same on
// every machine, or some compiler rounds otherwise.
#include "digest.hpp"

#include <string>
#include <support/rungs.hpp>

namespace {

using namespace tumble;

/// 2000 steps of 1/64 s, with moments whose quotients no binary number is equal to, and a torque
/// that keeps its direction in the world.
template <class Real>
void print_digests() {
  for (const TurningRung<Real>& rung : support::rungs<Real>()) {
    bits::Digest digest;
    Top<Real> top;
    top.inverse_moments = {Real(1), Real(0.7), Real(0.3)};
    top.angular_momentum_body = {Real(1.1), Real(2.3), Real(0.7)};
    top.torque = {Real(0.01), Real(-0.02), Real(0.03)};
    for (int step = 0; step < 2000; ++step) {
      kick(top, Real(0.015625));
      rung.turn(top, Real(0.015625));
      digest.take(top);
    }
    bits::print<Real>("rung " + std::string(rung.name), digest);
  }
}

}  // namespace

int main() {
  print_digests<float>();
  print_digests<double>();
}
