// What the checks of exercises are written with: how values cross the wire, and what earns a
// verdict.
#include <exercise/answers.hpp>
#include <exercise/judge.hpp>
#include <support/bad_vectors.hpp>
#include <tumble/rigid_body.hpp>

using namespace tumble;
using namespace tumble::exercise;
using support::not_finite;

namespace {

std::vector<double> numbers = {0,    -0.0, 1.0 / 3,       -1e-310, 5e-324, 1.7976931348623157e308,
                               1e22, 0.1f, 123456789.125, -2.5};

double halved(double x) {
  return x / 2;
}
Vec3d crossed(const Vec3d& a, const Vec3d& b) {
  return a.cross(b);
}
void pushed(Particled& particle, const Vec3d& force) {
  particle.force += force;
}
double refused(double x) {
  reject("x", x, "m", "it is never right");
}
double thrown(double) {
  throw std::runtime_error("two\nlines");
}
double unsaid(double) {
  throw std::invalid_argument("");
}
double left(double) {
  todo("the half");
}
double thrown_otherwise(double) {
  throw 5;
}

/// How a check that does `action` ends: its status and message, "passed" if it says nothing.
template <class Action>
std::string verdict_of(const Action& action) {
  try {
    action();
  } catch (const Verdict& verdict) {
    return verdict.status + ": " + verdict.message;
  } catch (const Unreadable& error) {
    return std::string("unreadable: ") + error.what();
  } catch (const std::logic_error& error) {
    return std::string("a fault of the check: ") + error.what();
  }
  return "passed";
}

template <class Value>
std::string judged(const Value& found, const Value& truth, double tolerance) {
  return verdict_of([&] { Found("the speed", "m/s", found).must_be(truth, tolerance); });
}

}  // namespace

namespace tumble::exercise {

// The worker, in this process.
std::pair<std::string, std::string> reply_to(const Question& asked) {
  Words words(asked.line);
  const std::string line = replied(words, {{"halved", answer<halved>},
                                           {"crossed", answer<crossed>},
                                           {"pushed", answer<pushed>},
                                           {"refused", answer<refused>},
                                           {"thrown", answer<thrown>},
                                           {"unsaid", answer<unsaid>},
                                           {"left", answer<left>},
                                           {"thrown_otherwise", answer<thrown_otherwise>}});
  const std::size_t space = std::min(line.find(' '), line.size());
  return {line.substr(0, space), line.substr(std::min(space + 1, line.size()))};
}

}  // namespace tumble::exercise

TEST_CASE("Numbers, vectors, lists and bodies cross the wire to the bit, and end where they end") {
  std::string line;
  put(line, numbers);
  Words words(line);
  std::vector<double> back;
  get(words, back);
  CHECK(words.empty());
  REQUIRE(back.size() == numbers.size());
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    CHECK(back[n] == numbers[n]);
    CHECK(std::signbit(back[n]) == std::signbit(numbers[n]));
  }
  for (const double bad : not_finite<double>) {
    std::string text;
    put(text, bad);
    const double same = Words(text).number();
    CHECK((std::isnan(bad) ? std::isnan(same) : same == bad));
  }

  // Each number of a body is another one, so that none can take the place of its neighbour.
  RigidBody<double> body, copy;
  double next = 1;
  const auto fill = [&next](auto& vector) {
    for (Eigen::Index i = 0; i < vector.size(); ++i) vector.data()[i] = next++ / 3;
  };
  fill(body.centre.position);
  fill(body.centre.velocity);
  fill(body.centre.force);
  fill(body.top.orientation.imaginary);
  fill(body.top.angular_momentum_body);
  fill(body.top.torque);
  fill(body.top.inverse_moments);
  body.centre.inverse_mass = 100;
  body.top.orientation.real = 101;
  std::string text;
  put(text, body);
  Words of_body(text);
  get(of_body, copy);
  CHECK(of_body.empty());
  std::string again;
  put(again, copy);
  CHECK(again == text);
  CHECK(support::same_bits(copy.top.inverse_moments, body.top.inverse_moments));
  CHECK(copy.centre.inverse_mass == 100);

  const auto read = [](std::string_view from) {
    return verdict_of([from] {
      Words from_text(from);
      std::vector<double> list;
      get(from_text, list);
    });
  };
  CHECK(read(" 2 1") == "unreadable: a word is missing");
  CHECK(read(" 1 1x") == "unreadable: no number: 1x");
  CHECK(read(" -1") == "unreadable: a list of impossible length");
  CHECK(read(" nan") == "unreadable: a list of impossible length");
  CHECK(read(" 1e300") == "unreadable: a list of impossible length");
  CHECK(read(" 1000001") == "unreadable: a list of impossible length");
}

TEST_CASE("A reply that is no count is refused before it becomes one") {
  const auto read = [](const std::string& word, auto number) {
    return verdict_of([&] {
      Words words(word);
      get(words, number);
      CHECK(std::to_string(number) == word);
    });
  };
  for (const char* word : {"0", "2147483647", "-2147483648"}) CHECK(read(word, 0) == "passed");
  for (const char* word : {"2147483648", "-2147483649", "0x1p+99", "inf", "nan", "0.5"})
    CHECK(read(word, 0) == "unreadable: no count: " + std::string(word));
  CHECK(read("1", false) == "passed");
  CHECK(read("2", false) == "unreadable: no count: 2");
  CHECK(read("-1", std::size_t{0}) == "unreadable: no count: -1");
  CHECK(read("18446744073709551616", std::size_t{0}) ==
        "unreadable: no count: 18446744073709551616");
}

TEST_CASE("A question is answered, with what was changed, or its refusal is told") {
  CHECK(ask<double>("halved", 3.0) == 1.5);
  CHECK(support::same_bits(ask<Vec3d>("crossed", Vec3d(1, 0, 0), Vec3d(0, 1, 0)), Vec3d(0, 0, 1)));
  const auto start = make_particle(2.0);
  CHECK(support::same_bits(ask<Particled>("pushed", start, Vec3d(1, 2, 3)).force, Vec3d(1, 2, 3)));
  CHECK(verdict_of([] { ask<Vec3d>("halved", 3.0); }) == "unreadable: a word is missing");
  CHECK(verdict_of([] { ask<double>("crossed", Vec3d(1, 0, 0), Vec3d(0, 1, 0)); }) ==
        "unreadable: words are left over");
  CHECK(verdict_of([] { ask<double>("refused", 3.0); }) ==
        "failed: refused gave up where it should have answered: \"x is 3 m; it is never right\"");
  CHECK(verdict_of([] { ask<double>("thrown", 3.0); }) ==
        "failed: thrown gave up where it should have answered: \"two lines\"");
  CHECK(reply_to({"left 1", {}, {}}).first == "todo");
  CHECK(reply_to({"left 1", {}, {}}).second == "the half");
  CHECK(reply_to({"nobody 1", {}, {}}).first == "unreadable");

  CHECK(ask_refusal("it must refuse", "refused", 3.0) == "x is 3 m; it is never right");
  CHECK(verdict_of([] { ask_refusal("it must refuse", "halved", 3.0); }) ==
        "failed: it must refuse");
  CHECK(verdict_of([] { ask_refusal("it must refuse", "thrown", 3.0); }) ==
        "failed: thrown threw, but not std::invalid_argument: \"two lines\"");
  CHECK(verdict_of([] { ask_refusal("it must refuse", "thrown_otherwise", 3.0); }) ==
        "failed: thrown_otherwise threw, but not std::invalid_argument: \"something that is no "
        "std::exception\"");
  CHECK(verdict_of([] { ask_refusal("it must refuse", "unsaid", 3.0); }) ==
        "failed: unsaid refused without a sentence that says why");
}

TEST_CASE("What is within the tolerance passes, and nothing that is not a number does") {
  CHECK(judged(1.5, 1.0, 0.5) == "passed");
  CHECK(judged(0.5, 1.0, 0.5) == "passed");
  CHECK(judged(1.0, 1.0, 0.0) == "passed");
  CHECK(judged(2.0, 1.0, 0.5) == "failed: the speed is 2 m/s; it must be 1 m/s");
  CHECK(judged(0.0, 1.0, 0.5) == "failed: the speed is 0 m/s; it must be 1 m/s");
  // Where one has to look for the digit in which they differ, also by how much it is off.
  CHECK(judged(1.005, 1.0, 1e-3) ==
        "failed: the speed is 1.005 m/s; it must be 1 m/s, and it is off by 0.005 m/s");
  CHECK(judged(1.02, 1.0, 1e-3) == "failed: the speed is 1.02 m/s; it must be 1 m/s");
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  CHECK(judged(nan, 1.0, 0.5) == "failed: the speed is nan m/s: that is not a number");
  CHECK(judged(infinity, 1.0, 0.5).find("failed: the speed is inf m/s") == 0);
  for (const Vec3d& bad : support::bad_vectors<double>())
    CHECK(judged<Vec3d>(bad, Vec3d(1, 2, 3), 0.5).find("failed: the speed is (") == 0);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d truth(1, 2, 3);
    CHECK(judged<Vec3d>(truth + 0.5 * Vec3d::Unit(axis), truth, 0.5) == "passed");
    CHECK(judged<Vec3d>(truth + 0.75 * Vec3d::Unit(axis), truth, 0.5) != "passed");
    CHECK(judged<Vec3d>(truth - 0.75 * Vec3d::Unit(axis), truth, 0.5) != "passed");
  }
  for (const double tolerance : not_finite<double>)
    CHECK(judged(1.0, 1.0, tolerance) == "a fault of the check: a tolerance is not finite");
  CHECK(verdict_of([&] {
          Found("the speed", "", nan).not_a_number("0/0 is none").must_be(1, 0.5);
        }) == "failed: the speed is nan: 0/0 is none");
  CHECK(verdict_of([] { require(false, "because"); }) == "failed: because");
  CHECK(verdict_of([] { require(true, "because"); }) == "passed");
}

TEST_CASE("A foreseen mistake gets its own sentence where nothing else would make that number") {
  const auto with_mistake = [](double found, double mistake, double truth, double tolerance) {
    return verdict_of([&] {
      Found("the speed", "m/s", found).mistake(mistake, "m forgotten").must_be(truth, tolerance);
    });
  };
  const std::string recognised = "failed: the speed is 2 m/s: m forgotten";
  CHECK(with_mistake(2, 2, 1, 0.01) == recognised);
  // It rounds by itself: four tolerances of its own size, twice the truth's.
  CHECK(with_mistake(2, 2.07, 1, 0.01) == recognised);
  CHECK(with_mistake(2, 2.1, 1, 0.01) == "failed: the speed is 2 m/s; it must be 1 m/s");
  // The right answer is right, even where a mistake makes the same; and so near to it, a mistake
  // can't be told.
  CHECK(with_mistake(1, 1, 1, 0.01) == "passed");
  CHECK(with_mistake(1.03, 1.02, 1, 0.01).find("m forgotten") == std::string::npos);
  CHECK(with_mistake(2, 2, 0, 0.01) == recognised);
}

namespace {

/// How two functions of three numbers agree, where the first three questions are asked.
Agreement compared(double (*one)(double, double, double), double (*other)(double, double, double),
                   double part = 0) {
  const auto by = [](auto function) {
    return [function](const std::string& line) {
      const auto x = Varied::Numbers({line, {}, {}}).values;
      std::string reply = "value";
      put(reply, function(x[0], x[1], x[2]));
      return reply;
    };
  };
  Asked asked;
  for (const double first : {2.0, 3.0, 5.0}) {
    const Question one_of_them = question("f", first, 4.0, 7.0);
    asked.emplace_back(one_of_them, by(other)(one_of_them.line));
  }
  Varied varied(1);
  return agreement(asked, by(one), by(other), varied, part, unit_roundoff<double>);
}

double product(double a, double b, double c) {
  return a * b / c;
}

}  // namespace

TEST_CASE("A function agrees with the reference where a table of its answers doesn't") {
  const auto agree = [](auto other, double part = 0) {
    const Agreement found = compared(product, other, part);
    CHECK(found.cases == 9);  // three numbers of three questions
    return found.right;
  };
  CHECK(agree(product) == 9);
  CHECK(agree([](double a, double b, double c) { return b / c * a; }) == 9);
  CHECK(agree([](double a, double, double) { return std::round(a) * 4 / 7; }) == 0);
  CHECK(agree([](double a, double, double) { return a * 4 / 7; }) == 3);
  // Off by as much as where the check asks is no more wrong than there; a table that is off is.
  const auto rough = [](double a, double b, double c) { return 1.001 * a * b / c; };
  CHECK(agree(rough) == 9);
  CHECK(agree([](double a, double, double) { return 1.001 * std::round(a) * 4 / 7; }) == 0);
  const auto right_where_asked = [](double a, double b, double c) {
    return a * b / c * (a == std::round(a) && b == 4 && c == 7 ? 1 : 1.01);
  };
  CHECK(agree(right_where_asked) == 0);
  CHECK(agree(right_where_asked, 0.02) == 9);
  // What the student has wrong where the check asks counts neither way.
  CHECK(compared(product, [](double a, double b, double c) { return 2 * a * b / c; }).cases == 0);
  CHECK(Agreement{0, 0}.is_enough());
  CHECK(Agreement{3, 2}.is_enough());
  CHECK_FALSE(Agreement{4, 2}.is_enough());
}

TEST_CASE("A varied question meets what is declared of it, and differs in one number alone") {
  static const Precondition declared[] = {
      {"g", 1, of_length_one}, {"g", 2, whole}, {"g", 3, 1, 9}, {"g", 4, powers_of_two}};
  Quaternion<double> q{.real = 0.5, .imaginary = Vec3d(0.5, -0.5, 0.5)};
  Mat3d tensor;
  tensor << 2, 0.25, 0, 0.25, 3, 0, 0, 0, 4;
  const auto asked = question("g", q, Vec3d(0.6, 0, 0.8), 3.0, 5, 0.125, tensor, 1.5);
  REQUIRE(asked.begins == std::vector<std::size_t>{0, 4, 7, 8, 9, 10, 19});
  REQUIRE(asked.quaternions == std::vector<std::size_t>{0});
  const auto before = Varied::Numbers(asked).values;
  Varied varied(1);
  for (std::size_t which = 0; which < before.size(); ++which)
    for (int n = 0; n < 8; ++n) {
      CAPTURE(which);
      const auto x = Varied::Numbers(varied.in(asked, which, 0.125)).values;
      REQUIRE(x.size() == before.size());
      CHECK(std::hypot(std::hypot(x[0], x[1], x[2]), x[3]) == doctest::Approx(1).epsilon(1e-15));
      CHECK(std::hypot(x[4], x[6]) == doctest::Approx(1).epsilon(1e-15));
      CHECK(x[7] == std::round(x[7]));
      CHECK((x[8] == before[8] || which == 8));
      CHECK((x[8] >= 1 && x[8] <= 9));
      CHECK(x[9] == std::exp2(std::round(std::log2(x[9]))));
      CHECK(x[11] == x[13]);
      CHECK(x[12] == 0);
      CHECK((x[19] == before[19] || which == 19));
      if (which == 19) CHECK(std::abs(x[19] / before[19] - 1) >= 0.125);
    }
}

TEST_CASE("Numbers are shown by five digits, a vector in a row and a matrix row by row") {
  CHECK(shown(1 / 3.0) == "0.33333");
  CHECK(shown(16777217) == "16777217");
  CHECK(shown(-0.0) == "0");
  for (const double sign : {1.0, -1.0})
    CHECK(shown(std::copysign(std::numeric_limits<double>::quiet_NaN(), sign)) == "nan");
  CHECK(shown(Vec3d(1, -2, 0.5)) == "(1, -2, 0.5)");
  Mat3d matrix;
  matrix << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  CHECK(shown(matrix) == "(1, 2, 3; 4, 5, 6; 7, 8, 9)");
  CHECK(largest(Vec3d(1, -4, 2)) == 4);
  CHECK(largest(-3.0) == 3);
  CHECK(one_line("two\nlines\tand\x01") == "two lines and ");
  CHECK(one_line(std::string(3000, 'x')).size() == 2000);
}

TEST_CASE("A sentence of numbers that differ shows them with the digits in which they differ") {
  CHECK(sentence("it is ", 1 / 3.0, " instead of ", 0.5) == "it is 0.33333 instead of 0.5");
  CHECK(sentence(0.5000004, " instead of ", 0.5) == "0.5000004 instead of 0.5");
  CHECK(sentence(1024.01f, ", ", 1024, " and ", 1024.02f) == "1024.01, 1024 and 1024.02");
  CHECK(sentence(0.5, " in place of ", 0.5) == "0.5 in place of 0.5");
  const Vec3d vector(1, 2, 1 / 3.0);
  CHECK(sentence(vector, " and ", Vec3d(vector + 1e-6 * Vec3d::UnitY())) ==
        "(1, 2, 0.3333333) and (1, 2.000001, 0.3333333)");
  // Neighbours, of every size and in both precisions; 0 and -0 are the same.
  const auto of_neighbours = [](auto number) {
    return sentence(number, " and ", std::nextafter(number, 2 * number)) !=
           sentence(number, " and ", number);
  };
  for (const double number : {1e-300, 0.1, 1 / 3.0, 1.0, 16666.7, 1e22}) {
    CAPTURE(number);
    CHECK(of_neighbours(number));
    if (number > 1e-30) CHECK(of_neighbours(float(number)));
  }
  CHECK(counted(1, "step") + " or " + counted(2, "step") == "1 step or 2 steps");
  CHECK(sentence(0.0, " and ", -0.0) == "0 and 0");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(sentence(nan, " and ", -nan) == "nan and nan");
  CHECK(judged(16666.676, 16666.667, 1e-3) ==
        "failed: the speed is 16666.68 m/s; it must be 16666.67 m/s, and it is off by 0.009 m/s");
}
