#include <random>
#include <support/checks.hpp>
#include <tumble/packed_bodies.hpp>
#include <tumble/tumbling.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
constexpr int width = natural_width<Real>;
template <class Real>
using Packed = Pack<Real, width<Real>>;

/// True when both numbers have the same bits, or both are NaN.
template <class Real>
bool same_number(Real x, Real y) {
  return x == y ? std::signbit(x) == std::signbit(y) : std::isnan(x) && std::isnan(y);
}

/// Numbers of all sizes, and those that are none.
template <class Real>
std::vector<Real> all_kinds_of_numbers() {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> numbers = {0,
                               -Real(0),
                               1,
                               -1,
                               Limits::infinity(),
                               -Limits::infinity(),
                               Limits::quiet_NaN(),
                               Limits::denorm_min(),
                               Limits::max(),
                               Limits::lowest()};
  std::mt19937 generator(12);
  std::uniform_real_distribution<Real> exponent(-30, 30), mantissa(-2, 2);
  while (numbers.size() < 512)
    numbers.push_back(mantissa(generator) * std::exp2(std::round(exponent(generator))));
  return numbers;
}

/// A pack of numbers from number `first` on, as if the list were a ring.
template <class Real>
Packed<Real> pack_of(const std::vector<Real>& numbers, std::size_t first) {
  Packed<Real> pack;
  for (int lane = 0; lane < width<Real>; ++lane)
    pack.lanes[lane] = numbers[(first + static_cast<std::size_t>(lane)) % numbers.size()];
  return pack;
}

/// Whether `function` gives each lane what it gives the numbers one by one.
template <class Real, class Function>
bool is_same_lane_by_lane(const Function& function) {
  const std::vector<Real> numbers = all_kinds_of_numbers<Real>();
  for (std::size_t shift = 0; shift < 8; ++shift)
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const Packed<Real> a = pack_of(numbers, i), b = pack_of(numbers, 3 * i + shift);
      const Packed<Real> result = function(a, b);
      for (int lane = 0; lane < width<Real>; ++lane)
        if (!same_number<Real>(result[lane], function(a[lane], b[lane]))) return false;
    }
  return true;
}

}  // namespace

TEST_CASE_TEMPLATE("Of three products the last two are added first, alone and in a pack", Real,
                   EVERY_PRECISION) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<Real> number(-1, 1);
  int other_order_differs = 0;
  for (int n = 0; n < 1000; ++n) {
    Vec3<Real> a, b;
    for (int i = 0; i < 3; ++i) {
      a[i] = number(generator);
      b[i] = number(generator);
    }
    const Vec3<Real> products = a.cwiseProduct(b);
    const Real sum = products.x() + (products.y() + products.z());
    other_order_differs += sum != (products.x() + products.y()) + products.z();
    Mat3<Real> rows = Mat3<Real>::Zero();
    rows.row(n % 3) = a;
    REQUIRE(dot(a, b) == sum);
    REQUIRE(dot(2 * a, -b) == -2 * sum);
    REQUIRE(products.sum() == sum);
    REQUIRE(Vec3<Real>(rows * b)[n % 3] == sum);
    const Vec3<Packed<Real>> wide_a = a.template cast<Packed<Real>>(),
                             wide_b = b.template cast<Packed<Real>>();
    REQUIRE(dot(wide_a, wide_b)[0] == sum);
    REQUIRE(wide_a.squaredNorm()[0] == a.squaredNorm());
  }
  CHECK(other_order_differs > 100);  // so a sum from the front would be seen
}

TEST_CASE_TEMPLATE("A number is the same in every lane of a pack, and a zero keeps its sign", Real,
                   EVERY_PRECISION) {
  for (const Real number : all_kinds_of_numbers<Real>())
    for (int lane = 0; lane < width<Real>; ++lane)
      REQUIRE(same_number(Packed<Real>(number)[lane], number));
}

TEST_CASE("A pack has a lane for each number of a register: twice as many floats as doubles") {
  CHECK(width<float> == 2 * width<double>);
  CHECK(sizeof(Packed<float>) == vector_bytes);
  CHECK(sizeof(Packed<double>) == vector_bytes);
}

TEST_CASE_TEMPLATE("A pack computes in each lane what a number alone would, to the bit", Real,
                   EVERY_PRECISION) {
  using std::abs, std::sqrt;
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a + b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a - b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a * b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a / b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a += b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a -= b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a *= b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return a /= b; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto) { return -a; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto) { return abs(a); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto) { return sqrt(a); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return select(a < b, a, b); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return select(a <= b, a, b); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return select(a == b, a, b); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return select(a != b, a, b); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return select(a > 0 && b > 0, a, b); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return select(a >= 0 || b < 0, a, b); }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto b) { return select(!(a > b), a, b); }));
}

TEST_CASE_TEMPLATE("Sine and cosine of a pack are those of its numbers, to the bit", Real,
                   EVERY_PRECISION) {
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto) { return sine_cosine(a).sine; }));
  CHECK(is_same_lane_by_lane<Real>([](auto a, auto) { return sine_cosine(a).cosine; }));
}

TEST_CASE_TEMPLATE("Every rule of chapter 8 turns a pack as it turns its tops, to the bit", Real,
                   EVERY_PRECISION) {
  std::mt19937 generator(8);
  std::uniform_real_distribution<Real> some(-1, 1);
  const auto vector = [&] {
    const Real x = some(generator), y = some(generator);
    return Vec3<Real>(x, y, some(generator));
  };
  const auto compare = [&](const auto& rule) {
    Top<Packed<Real>> pack;
    std::array<Top<Real>, width<Real>> tops;
    for (int lane = 0; lane < width<Real>; ++lane) {
      Top<Real>& top = tops[static_cast<std::size_t>(lane)];
      top.orientation = quaternion_of_rotation_vector<Real>(3 * vector());
      top.angular_momentum_body = 9 * vector();
      top.torque = vector();
      top.inverse_moments = Vec3<Real>(2, 2, 2) + vector();
      set_lane(pack, lane, top);
    }
    for (int step = 0; step < 20; ++step) {
      rule(pack, Packed<Real>(Real(0.1)));
      for (Top<Real>& top : tops) rule(top, Real(0.1));
    }
    for (int lane = 0; lane < width<Real>; ++lane) {
      const Top<Real>& top = tops[static_cast<std::size_t>(lane)];
      const Top<Real> same = lane_of(pack, lane);
      CHECK(same_bits(same.angular_momentum_body, top.angular_momentum_body));
      CHECK(same_bits(same.orientation.imaginary, top.orientation.imaginary));
      CHECK(same_number(same.orientation.real, top.orientation.real));
    }
  };
  compare([](auto& top, auto h) { turn_steadily(top, h); });
  compare([](auto& top, auto h) { turn_explicitly(top, h / 16); });
  compare([](auto& top, auto h) { turn_restoring_momentum(top, h); });
  compare([](auto& top, auto h) { turn_implicitly(top, h); });
  compare([](auto& top, auto h) { turn_carrying_momentum(top, h); });
  compare([](auto& top, auto h) { turn_axis_by_axis(top, h); });
  compare([](auto& top, auto h) { turn_by_splitting(top, h); });
  compare([](auto& top, auto h) { turn_by_splitting_without_sine(top, h); });
  compare([](auto& top, auto h) { kick(top, h), turn_by_splitting(top, h); });
}
