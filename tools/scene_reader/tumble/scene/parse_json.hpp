/// @file
/// From text to JSON, with limits, and with the place of whatever is wrong.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tumble/scene/scene_error.hpp>

namespace tumble {

/// What no scene file needs more of.
constexpr std::size_t most_bytes_of_scene = 64 << 20;
constexpr std::size_t deepest_nesting = 32;

/// The pointer to an element of what `pointer` points to; "/" and "~" are written as RFC 6901 asks.
inline std::string pointer_to(const std::string& pointer, std::string_view key) {
  std::string longer = pointer + '/';
  for (const char letter : key)
    if (letter == '~')
      longer += "~0";
    else if (letter == '/')
      longer += "~1";
    else
      longer += letter;
  return longer;
}

/// Takes the parser's events and builds the value. The library's own builder silently drops the
/// first of two equal keys, has no limit of depth, and can't say where a number was too large. What
/// is no JSON is told with our own line and column; the parser's words, which differ from version
/// to version, stand behind them.
class JsonBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// @param text what the parser is given, and the builder reads for its lines alone
  JsonBuilder(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  nlohmann::json take() { return std::move(root_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t&) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // text has none

  bool start_object(std::size_t) override { return open(nlohmann::json::object()); }
  bool start_array(std::size_t) override { return open(nlohmann::json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    if (open_.back()->contains(key))
      throw SceneError(file_, pointer_to(pointer(), key), "stands there twice; a key must be one");
    keys_.back() = key;
    return true;
  }

  bool parse_error(std::size_t bytes_read, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    if (error.id == 406)  // the library's number for a number beyond all doubles
      throw SceneError(file_, pointer_to(pointer(), next_key()),
                       "is " + token + "; no number can be that large");
    std::string words = error.what();
    // Before the first ": " stand the library's number of the error and the place once more.
    if (const std::size_t end = words.find(": "); end != std::string::npos) words.erase(0, end + 2);
    throw SceneError(file_, "", place_of(bytes_read) + "not valid JSON (" + words + ")");
  }

 private:
  /// The line and column of the last of the bytes that were read; the end of the text counts as
  /// one.
  std::string place_of(std::size_t bytes_read) const {
    const std::string_view before = text_.substr(0, bytes_read == 0 ? 0 : bytes_read - 1);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 = 0: the first line
    return "line " + std::to_string(lines + 1) + ", column " +
           std::to_string(before.size() - line_begin + 1) + ": ";
  }

  std::string next_key() const {
    if (open_.empty()) return {};
    return open_.back()->is_array() ? std::to_string(open_.back()->size()) : keys_.back();
  }

  std::string pointer() const {
    std::string text;
    for (std::size_t level = 0; level + 1 < open_.size(); ++level)
      text = pointer_to(
          text, open_[level]->is_array() ? std::to_string(open_[level]->size() - 1) : keys_[level]);
    return text;
  }

  nlohmann::json* place(nlohmann::json&& value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (open_.back()->is_array()) {
      open_.back()->push_back(std::move(value));
      return &open_.back()->back();
    }
    return &((*open_.back())[keys_.back()] = std::move(value));
  }

  template <class Value>
  bool put(Value&& value) {
    place(std::forward<Value>(value));
    return true;
  }

  bool open(nlohmann::json&& empty) {
    if (open_.size() == deepest_nesting)
      throw SceneError(file_, pointer(),
                       "is nested more than " + std::to_string(deepest_nesting) + " levels deep");
    open_.push_back(place(std::move(empty)));
    keys_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  std::string_view text_;
  std::string file_;
  nlohmann::json root_;
  std::vector<nlohmann::json*> open_;  // objects and arrays that have not ended
  std::vector<std::string> keys_;      // the key that each of them is at
};

/// The JSON value that `text` holds.
/// @throws SceneError with line and column if it is no JSON, with the pointer if a number is beyond
/// all doubles or a key stands twice in an object, or if a limit is exceeded.
inline nlohmann::json parse_json(std::string_view text, const std::string& file) {
  if (text.size() > most_bytes_of_scene)
    throw SceneError(file, "",
                     "it has " + std::to_string(text.size()) + " bytes; at most " +
                         std::to_string(most_bytes_of_scene) + " are read");
  JsonBuilder builder(text, file);
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace tumble
