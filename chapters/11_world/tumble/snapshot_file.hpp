/// @file
/// A snapshot as a file.
#pragma once

#include <cstdlib>
#include <istream>
#include <iterator>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tumble/snapshot.hpp>

namespace tumble {

namespace detail {

/// Calls `visit` with each number of a snapshot, in the order of a file.
template <class AnySnapshot, class Visit>
void for_each_number(AnySnapshot& snapshot, const Visit& visit) {
  const auto visit_vector = [&](auto& vector) {
    for (int axis = 0; axis < 3; ++axis) visit(vector[axis]);
  };
  for (auto& centre : snapshot.centres) visit_vector(centre.position);
  for (auto& centre : snapshot.centres) visit_vector(centre.velocity);
  for (auto& top : snapshot.tops) visit_vector(top.angular_momentum_body);
  for (auto& top : snapshot.tops) {
    visit(top.orientation.real);
    visit_vector(top.orientation.imaginary);
  }
}

}  // namespace detail

/// The checksum of a text, by Fowler, Noll and Vo: no change of a single letter goes unseen.
inline std::uint64_t checksum_of(std::string_view text) {
  std::uint64_t sum = 14695981039346656037ull;
  for (const char letter : text)
    sum = (sum ^ static_cast<unsigned char>(letter)) * 1099511628211ull;
  return sum;
}

namespace detail {

/// The last line of the file whose other lines are `text`.
inline std::string checksum_line(std::string_view text) {
  std::ostringstream line;
  line << "checksum " << std::hex << checksum_of(text) << '\n';
  return line.str();
}

/// A number in hexadecimal, which no stream reads back.
template <class Real>
Real number_of(const std::string& text) {
  return static_cast<Real>(std::strtod(text.c_str(), nullptr));
}

}  // namespace detail

/// Writes a snapshot as text: a line that says what it is, the numbers in hexadecimal, so that none
/// is rounded, and a checksum. It has how all bodies move and the time, and no body, effect, mass
/// or name: who loads it makes the same scene first. Whether it was written, the stream's state
/// says.
template <class Real>
void write_snapshot(std::ostream& out, const Snapshot<Real>& snapshot) {
  std::ostringstream text;
  text << std::hexfloat << "tumble snapshot 2, " << 8 * sizeof(Real) << " bits, bodies "
       << snapshot.centres.size() << ", tops " << snapshot.tops.size() << ", ticks "
       << snapshot.ticks << ", step " << snapshot.step.numerator << " / "
       << snapshot.step.denominator << " ns since " << snapshot.first_tick << " at "
       << snapshot.start << " s\n";
  for (const std::vector<bool>* flags : {&snapshot.has_moved, &snapshot.has_turned}) {
    for (const bool flag : *flags) text << (flag ? '1' : '0');
    text << '\n';
  }
  detail::for_each_number(snapshot, [&](const Real& number) { text << number << '\n'; });
  out << text.str() << detail::checksum_line(text.str());
}

/// Reads what write_snapshot() has written. A file of version 1 does not know its step: it is taken
/// for one of the world's.
/// @throws std::invalid_argument with what is wrong, if it is something else or is damaged.
template <class Real>
Snapshot<Real> read_snapshot(std::istream& in) {
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  const auto refuse = [](const std::string& why) -> std::invalid_argument {
    return std::invalid_argument("not a snapshot that can be used: " + why);
  };
  const std::string mark = "tumble snapshot ";
  if (all.compare(0, mark.size(), mark) != 0)
    throw refuse("it does not begin with \"" + mark + "\"");
  const std::size_t end = all.rfind("checksum ");
  if (end == std::string::npos) throw refuse("its end is missing");
  int version = 0;
  std::size_t bits = 0, bodies = 0, tops = 0;
  std::istringstream text(all.substr(0, end));
  std::string word;
  Snapshot<Real> snapshot;
  text >> word >> word >> version >> word >> bits >> word >> word >> bodies >> word >> word >>
      tops >> word >> word >> snapshot.ticks;
  if (version != 1 && version != 2)
    throw refuse("it is of version " + std::to_string(version) + ", and this is 2");
  if (version == 2) {
    text >> word >> word >> snapshot.step.numerator >> word >> snapshot.step.denominator >> word >>
        word >> snapshot.first_tick >> word >> word;
    snapshot.start = detail::number_of<Real>(word);
    text >> word;
  }
  if (!text) throw refuse("its first line does not say what it holds");
  if (all.substr(end) != detail::checksum_line(all.substr(0, end)))
    throw refuse("its checksum is wrong: it is damaged");
  if (bits != 8 * sizeof(Real))
    throw refuse("its numbers have " + std::to_string(bits) + " bits, and the world's " +
                 std::to_string(8 * sizeof(Real)));
  for (std::vector<bool>* flags : {&snapshot.has_moved, &snapshot.has_turned}) {
    if (bodies == 0) continue;
    text >> word;
    for (const char flag : word) flags->push_back(flag == '1');
  }
  snapshot.centres.resize(bodies);
  snapshot.tops.resize(tops);
  detail::for_each_number(snapshot, [&](Real& number) {
    text >> word;
    number = detail::number_of<Real>(word);
  });
  return snapshot;
}

}  // namespace tumble
