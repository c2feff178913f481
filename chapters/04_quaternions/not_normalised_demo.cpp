// A mistake, run on purpose: quaternions whose norm is not 1, used as if it were.
#include <numbers>
#include <support/record.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

Vec3f sandwich(const Quaternionf& q, const Vec3f& v) {
  return (q * pure(v) * conjugate(q)).imaginary;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);

  //! [axis]
  // An axis of length √2, put into the formula for one of length 1.
  const Vec3f axis(1, 1, 0);
  const SineCosine<float> half_turn = sine_cosine(std::numbers::pi_v<float> / 4);
  const Quaternionf q = {.real = half_turn.cosine, .imaginary = half_turn.sine * axis};
  //! [axis]
  std::printf("an axis of length 1.41 makes a quaternion of norm %.3f\n", norm(q));
  std::printf("a stick 1 m long:        q v q* makes it %.3f m, rotate(q, v) %.3f m\n",
              sandwich(q, {1, 0, 0}).norm(), rotate(q, {1, 0, 0}).norm());
  const Quaternionf right = quaternion_about(axis, std::numbers::pi_v<float> / 2);
  std::printf("with quaternion_about:   q v q* makes it %.3f m, rotate(q, v) %.3f m\n\n",
              sandwich(right, {1, 0, 0}).norm(), rotate(right, {1, 0, 0}).norm());
  support::expect(std::abs(sandwich(q, {1, 0, 0}).norm() - 1.5f) < 1e-5f,
                  "q v q* stretches by 1.5");

  //! [wheel]
  // A wheel of radius 1 m turns a little, a million times. The small turn is rounded once, so
  // its norm misses 1 by the same hair every time.
  const Quaternionf turn = quaternion_about(Vec3f(0, 0, 1), 0.01f);
  Quaternionf never, always;
  for (int n = 1; n <= 1'000'000; ++n) {
    never = turn * never;
    always = normalized(turn * always);
    //! [wheel]
    if (n == 1000 || n == 10'000 || n == 100'000 || n == 1'000'000)
      std::printf("after %7d turns: norm %.7f, the rim at %.5f m; normalised: %.7f, %.5f m\n", n,
                  norm(never), sandwich(never, {1, 0, 0}).norm(), norm(always),
                  sandwich(always, {1, 0, 0}).norm());
  }
  const double rim = sandwich(never, {1, 0, 0}).norm();
  notebook.value("rim", support::number("%.1f %%", 100 * std::abs(rim - 1)));
  notebook.value("rim_is", rim > 1 ? "larger" : "smaller");
  support::expect(std::abs(rim - 1) > 1e-3, "a million roundings of one sign change the radius");
  support::expect(std::abs(norm(always) - 1) < 3e-7, "normalised, the norm stays 1");
}
