/// @file
/// Values as words, on their way between the process that runs a student's code and the one that
/// judges it. Numbers keep every bit.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tumble/real.hpp>
#include <tuple>
#include <type_traits>
#include <vector>

namespace tumble::exercise {

/// What came over the wire is not what was asked for.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The members of a chapter's struct, in their order, known by their names: so a floor need not
/// include the floors above it.
template <class Particle>
auto fields(Particle& particle) requires requires {
  particle.inverse_mass;
}
{ return std::tie(particle.position, particle.velocity, particle.force, particle.inverse_mass); }
template <class Wrench>
auto fields(Wrench& wrench) requires requires {
  wrench.about;
}
{ return std::tie(wrench.about, wrench.force, wrench.torque); }
template <class MassProperties>
auto fields(MassProperties& body) requires requires {
  body.centre_of_mass;
}
{ return std::tie(body.mass, body.centre_of_mass, body.inertia); }
template <class Quaternion>
auto fields(Quaternion& q) requires requires {
  q.imaginary;
}
{ return std::tie(q.real, q.imaginary); }
template <class Top>
auto fields(Top& top) requires requires {
  top.inverse_moments;
}
{ return std::tie(top.orientation, top.angular_momentum_body, top.torque, top.inverse_moments); }
template <class RigidBody>
auto fields(RigidBody& body) requires requires {
  body.top;
}
{ return std::tie(body.centre, body.top); }

inline void put(std::string& line, double number) {
  char word[64];
  std::snprintf(word, sizeof word, " %a", number);
  line += word;
}

/// A count, an index or a truth, in digits: so the judge can tell it from a quantity, which may
/// vary.
template <class Whole>
void put(std::string& line, Whole number) requires std::is_integral_v<Whole> {
  line += ' ' + std::to_string(number);
}

template <int rows, int columns, class Real>
void put(std::string& line, const Eigen::Matrix<Real, rows, columns>& matrix) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) put(line, double(matrix.data()[i]));
}

template <class Struct>
auto put(std::string& line, const Struct& value) -> decltype(fields(value), void()) {
  std::apply([&line](const auto&... field) { (put(line, field), ...); }, fields(value));
}

template <class Item>
void put(std::string& line, const std::vector<Item>& items) {
  put(line, items.size());
  for (const Item& item : items) put(line, item);
}

/// Takes the words of a line one by one.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view word() {
    const std::size_t from = rest_.find_first_not_of(' ');
    if (from == rest_.npos) throw Unreadable("a word is missing");
    rest_.remove_prefix(from);
    const std::string_view found = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(found.size());
    return found;
  }

  bool empty() const { return rest_.find_first_not_of(' ') == rest_.npos; }

  double number() {
    const std::string text(word());
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() + text.size()) throw Unreadable("no number: " + text);
    return value;
  }

 private:
  std::string_view rest_;
};

template <class Number>
void get(Words& words, Number& number) requires std::is_arithmetic_v<Number> {
  const std::string_view word = words.word();
  const double value = Words(word).number();
  if constexpr (std::is_integral_v<Number>) {
    // To convert what doesn't fit is undefined, and a worker may say anything.
    const double end = std::ldexp(1.0, std::numeric_limits<Number>::digits);
    const double least = std::is_signed_v<Number> ? -end : 0.0;
    if (!(value >= least && value < end && value == std::trunc(value)))
      throw Unreadable("no count: " + std::string(word));
  }
  number = static_cast<Number>(value);
}

template <int rows, int columns, class Real>
void get(Words& words, Eigen::Matrix<Real, rows, columns>& matrix) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) get(words, matrix.data()[i]);
}

template <class Struct>
auto get(Words& words, Struct& value) -> decltype(fields(value), void()) {
  std::apply([&words](auto&... field) { (get(words, field), ...); }, fields(value));
}

template <class Item>
void get(Words& words, std::vector<Item>& items) {
  const double count = words.number();
  if (!(count >= 0 && count <= 1e6)) throw Unreadable("a list of impossible length");
  items.resize(static_cast<std::size_t>(count));
  for (Item& item : items) get(words, item);
}

/// A text in one line, whatever it held.
inline std::string one_line(std::string_view text) {
  std::string line(text.substr(0, 2000));
  for (char& letter : line)
    if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
  return line;
}

}  // namespace tumble::exercise
