/// @file
/// What the checks of an exercise are written with. They run in a process of their own, which asks
/// another one, the worker, what the student's functions return.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <exercise/reference.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <tumble/require.hpp>
#include <utility>
#include <vector>

namespace tumble::exercise {

/// Half the distance from 1 to the next number: the largest relative error of one rounded
/// operation.
template <class Real>
constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// Ends the check with a verdict other than "passed".
struct Verdict {
  std::string status, message;
};

/// Ends the check: its fact doesn't hold, and this sentence teaches why.
[[noreturn]] inline void fail(const std::string& message) {
  throw Verdict{"failed", message};
}

/// Ends the check with the sentence unless the fact holds.
inline void require(bool fact, const std::string& message) {
  if (!fact) fail(message);
}

/// Sends a question to the worker and returns the first word of its reply with the rest.
std::pair<std::string, std::string> reply_to(const Question& question);

/// A number that an instructor may choose for each student; exercise.json names it.
double parameter(std::string_view name);

/// How far, as a part of its size, another answer may be off that is right as well: 0 but where a
/// task leaves open by which rule something is computed, and a check says so. What is asked while
/// it is 1 is compared with nothing.
inline double& may_be_off() {
  static double part = 0;
  return part;
}

/// What the student's function returns; or, of a void one, the argument that it changes.
template <class Result, class... Arguments>
Result ask(const char* function, const Arguments&... arguments) {
  const auto [kind, rest] = reply_to(question(function, arguments...));
  if (kind == "refused" || kind == "threw")
    fail(std::string(function) + " gave up where it should have answered: \"" + rest + "\"");
  Words words(rest);
  Result result;
  get(words, result);
  if (!words.empty()) throw Unreadable("words are left over");
  return result;
}

/// The sentence with which the student's function refuses its arguments, by throwing
/// std::invalid_argument; it fails the check if it answers.
template <class... Arguments>
std::string ask_refusal(const std::string& otherwise, const char* function,
                        const Arguments&... arguments) {
  const auto [kind, rest] = reply_to(question(function, arguments...));
  if (kind == "threw")
    fail(std::string(function) + " threw, but not std::invalid_argument: \"" + rest + "\"");
  if (kind != "refused") fail(otherwise);
  if (rest.empty()) fail(std::string(function) + " refused without a sentence that says why");
  return rest;
}

constexpr int usual_digits = 5;

/// A number, vector or tensor as a sentence shows it. A count has all its digits; neither 0 nor
/// what is no number has a sign.
template <class Real>
std::string shown(Real number, int digits = usual_digits) requires std::is_arithmetic_v<Real> {
  if constexpr (std::is_integral_v<Real>) {
    return std::to_string(number);
  } else {
    if (std::isnan(number)) return "nan";
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, number == 0 ? 0.0 : double(number));
    return text;
  }
}
template <class Real, int rows, int columns>
std::string shown(const Eigen::Matrix<Real, rows, columns>& matrix, int digits = usual_digits) {
  std::string text = "(";
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      if (i + j > 0) text += j == 0 && columns > 1 ? "; " : ", ";
      text += shown(matrix(i, j), digits);
    }
  return text + ")";
}
inline std::string shown(const std::string& text, int) {
  return text;
}

/// How many digits it takes to tell apart those of the values that differ: the usual ones, or more.
template <class... Values>
int digits_apart(const Values&... values) {
  const auto shown_with = [&](int digits) { return std::array{shown(values, digits)...}; };
  const auto exact = shown_with(std::numeric_limits<double>::max_digits10);
  for (int digits = usual_digits;; ++digits) {
    const auto texts = shown_with(digits);
    bool apart = true;
    for (std::size_t i = 0; i < texts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        apart = apart && (texts[i] != texts[j] || exact[i] == exact[j]);
    if (apart) return digits;
  }
}

/// A sentence of texts and of values, which are shown with so many digits that it never says "is
/// 0.5 instead of 0.5".
template <class... Parts>
std::string sentence(const Parts&... parts) {
  const int digits = digits_apart(parts...);
  return (shown(parts, digits) + ...);
}

/// "1 step", "2 steps".
inline std::string counted(int count, const std::string& what) {
  return sentence(count, " ", what, count == 1 ? "" : "s");
}

template <class Real>
double farthest(Real a, Real b) requires std::is_arithmetic_v<Real> {
  return std::abs(double(a) - double(b));
}
template <class Real, int rows, int columns>
double farthest(const Eigen::Matrix<Real, rows, columns>& a,
                const Eigen::Matrix<Real, rows, columns>& b) {
  double distance = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const double d = farthest(a.data()[i], b.data()[i]);
    if (!(d <= distance)) distance = d;  // a NaN gets through too
    if (std::isnan(d)) return d;
  }
  return distance;
}

/// The size of the largest component.
template <class Value>
double largest(const Value& value) {
  return farthest(value, Value(value - value));
}

/// What the student's code found, on its way to a verdict.
template <class Value>
class Found {
 public:
  Found(std::string what, std::string unit, const Value& value)
      : what_(std::move(what)), unit_(unit.empty() ? "" : " " + unit), value_(value) {}

  /// The value that a mistake often made would give, and the sentence meant for whoever made it.
  Found& mistake(const Value& value, std::string message) {
    mistakes_.emplace_back(value, std::move(message));
    return *this;
  }

  /// The sentence for whoever got no number at all.
  Found& not_a_number(std::string message) {
    nan_message_ = std::move(message);
    return *this;
  }

  /// Ends the check unless every component is finite and within `tolerance` of the truth.
  /// @throws std::logic_error if the tolerance is infinite or NaN, as one that was made from a
  /// student's number may be: it would let everything pass.
  void must_be(const Value& truth, double tolerance) const {
    if (!std::isfinite(tolerance)) throw std::logic_error("a tolerance is not finite");
    if (farthest(value_, truth) <= tolerance) return;
    const int digits = digits_apart(value_, truth);
    const std::string found = what_ + " is " + shown(value_, digits) + unit_;
    for (const auto& [value, message] : mistakes_) {
      // A mistake rounds in its own way, and in proportion to its own size.
      const double times_larger = largest(truth) > 0 ? largest(value) / largest(truth) : 1;
      const double near = 4 * tolerance * std::max(1.0, times_larger);
      if (farthest(value_, value) <= near && farthest(value, truth) > near)
        fail(found + ": " + message);
    }
    const double off = farthest(value_, truth);
    if (std::isnan(off)) fail(found + ": " + nan_message_);
    // So near that one has to look for the digit in which they differ.
    const bool is_near = off < largest(truth) / 100;
    fail(found + "; it must be " + shown(truth, digits) + unit_ +
         (is_near ? ", and it is off by " + shown(off) + unit_ : ""));
  }

 private:
  std::string what_, unit_, nan_message_ = "that is not a number";
  Value value_;
  std::vector<std::pair<Value, std::string>> mistakes_;
};

/// A check of the exercise, in both precisions.
struct Check {
  Check(const char* sentence, void (*in_double)(), void (*in_float)());
  const char* sentence;
  void (*in_double)();
  void (*in_float)();
};

}  // namespace tumble::exercise

#define EXERCISE_JOINED_INNER(a, b) a##b
#define EXERCISE_JOINED(a, b) EXERCISE_JOINED_INNER(a, b)

/// A check: a sentence that states the fact, then a body in which `Real` is the precision.
#define EXERCISE_CHECK(sentence) EXERCISE_CHECK_NAMED(sentence, EXERCISE_JOINED(check_, __LINE__))
#define EXERCISE_CHECK_NAMED(sentence, name)                                                      \
  template <class Real>                                                                           \
  void name();                                                                                    \
  static const tumble::exercise::Check EXERCISE_JOINED(name, _registered)(sentence, name<double>, \
                                                                          name<float>);           \
  template <class Real>                                                                           \
  void name()
