/// @file
/// A figure that a reader can touch is a function from knobs, and texts where it has some, to
/// columns of numbers. The same function makes the still picture, as a program, and the moving one,
/// as a module of WebAssembly in the page.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <support/json_text.hpp>
#include <tumble/require.hpp>
#include <utility>
#include <vector>

namespace tumble::support {

/// What the reader has set, and what follows from it.
class Live {
 public:
  struct Knob {
    std::string name, unit;
    double start, least, most;
  };
  struct Column {
    std::string name, unit;
    std::vector<double> values;
  };

  /// `set`: the knobs' values in the order in which they are asked for; where it ends, the others
  /// stand at their start. `drawn`: what was drawn by hand, empty at the start. `written`: the
  /// texts that differ from their start, each as_written().
  explicit Live(std::vector<double> set = {}, std::vector<double> drawn = {},
                std::string written = {})
      : set_(std::move(set)), drawn_(std::move(drawn)), written_(std::move(written)) {}

  /// The value of the next knob. Every run asks for the same knobs in the same order.
  /// @throws std::invalid_argument if it was set to less than `least` or more than `most`.
  double knob(std::string_view name, std::string_view unit, double start, double least,
              double most) {
    const double value = knobs_.size() < set_.size() ? set_[knobs_.size()] : start;
    knobs_.push_back({std::string(name), std::string(unit), start, least, most});
    require_between(name, value, unit, least, most);
    return value;
  }

  /// The next knob as one of `count` choices, counted from 0.
  /// @throws std::invalid_argument if it is no such number.
  int choice(std::string_view name, int start, int count) {
    const double value = knob(name, "", start, 0, count - 1);
    if (value != std::floor(value)) reject(name, value, "", "a choice is a whole number");
    return static_cast<int>(value);
  }

  /// A text with its name: name, zero, count of bytes, zero, bytes.
  static std::string as_written(const std::string& name, const std::string& text) {
    return name + '\0' + std::to_string(text.size()) + '\0' + text;
  }

  /// A text that a reader may edit.
  std::string text(std::string_view name, std::string_view start) {
    add_text(starts_, name, start);
    std::string_view rest = written_;
    const auto take = [&rest](std::size_t count) {
      const std::string_view front = rest.substr(0, count);
      rest.remove_prefix(std::min(rest.size(), count));
      return front;
    };
    while (!rest.empty()) {
      const std::string_view its_name = take(rest.find('\0')), zero = take(1),
                             length = take(rest.find('\0'));
      take(zero.size());
      std::size_t bytes = 0;
      std::from_chars(length.data(), length.data() + length.size(), bytes);
      const std::string_view its_text = take(bytes);
      if (its_name == name) return std::string(its_text);
    }
    return std::string(start);
  }

  std::span<const double> drawn() const { return drawn_; }

  /// A new column, to be filled. It stays where it is while others are added.
  std::vector<double>& column(std::string_view name, std::string_view unit) {
    return columns_.emplace_back(Column{std::string(name), std::string(unit), {}}).values;
  }

  /// Words that a page shows, or JSON that it draws from.
  void say(std::string_view name, std::string_view words) { add_text(said_, name, words); }

  /// Says that this run has done only a part of the work, so that a page has time for a picture.
  /// Whoever called run_live() calls it again with the same knobs, until a run says nothing. What
  /// is done already must be kept meanwhile; the columns of the last run alone have to be right.
  void go_on() { goes_on_ = true; }
  bool goes_on() const { return goes_on_; }

  const std::vector<Knob>& knobs() const { return knobs_; }
  const std::deque<Column>& columns() const { return columns_; }

  /// The texts at their start, and the words: what stands between the braces of a JSON object.
  const std::string& starts() const { return starts_; }
  const std::string& said() const { return said_; }

 private:
  static void add_text(std::string& json, std::string_view name, std::string_view text) {
    json.append(json.empty() ? "" : ",").append(json_text(name)).append(":");
    json.append(json_text(text));
  }

  std::vector<double> set_, drawn_;
  std::string written_, starts_, said_;
  std::vector<Knob> knobs_;
  std::deque<Column> columns_;
  bool goes_on_ = false;
};

/// What a figure is: each defines it once, in a file of its own.
void run_live(Live& live);

/// Knobs and columns as JSON, without the columns' numbers, for `with_numbers(column)` to add.
template <class Numbers>
std::string as_json(const Live& live, const Numbers& with_numbers) {
  std::string json = live.goes_on() ? "{\"goes_on\":true,\"knobs\":[" : "{\"knobs\":[";
  const auto add = [&json](const char* key, std::string_view text) {
    json.append(key).append(text).append("\"");
  };
  for (const Live::Knob& knob : live.knobs()) {
    json.append(&knob == &live.knobs().front() ? "" : ",");
    add("{\"name\":\"", knob.name);
    add(",\"unit\":\"", knob.unit);
    json.append(",\"start\":").append(text_of(knob.start));
    json.append(",\"least\":").append(text_of(knob.least));
    json.append(",\"most\":").append(text_of(knob.most)).append("}");
  }
  json.append("],\"columns\":[");
  for (const Live::Column& column : live.columns()) {
    json.append(&column == &live.columns().front() ? "" : ",");
    add("{\"name\":\"", column.name);
    add(",\"unit\":\"", column.unit);
    with_numbers(json, column);
    json.append("}");
  }
  json.append("],\"texts\":{").append(live.starts());
  return json.append("},\"said\":{").append(live.said()).append("}}");
}

}  // namespace tumble::support
