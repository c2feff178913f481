/// @file
/// The independent items of a program that runs for long, so that several machines can share them:
/// `./course book --full --shard 3/16`.
#pragma once

#include <functional>
#include <iterator>
#include <sstream>
#include <support/record.hpp>
#include <utility>
#include <vector>

namespace tumble::support {

/// A program names its items first and asks for their results afterwards. The environment's
/// TUMBLE_ITEMS says what is done:
///
///   nothing        all items, each when its result is asked for
///   names          prints their names, one a line
///   only NAME      does that item alone and prints its result
///   from FOLDER    does none: the result of the first is in FOLDER/0.txt, and what it expected in
///   vain in FOLDER/0.errors
///
/// An item depends on nothing but the program and its name, and its result is a text in every case.
/// So a program says the same wherever its items were done. Times that are compared with each other
/// belong into one item.
class Items {
 public:
  /// Its name is unlike all others and has no line's end.
  void add(std::string name, std::function<std::string()> work) {
    items_.push_back({std::move(name), std::move(work)});
  }

  /// Whether the program is to go on with the results. If not, all that was asked for is done.
  bool are_wanted() const {
    if (asked_ == "names") {
      for (const auto& [name, work] : items_) std::printf("%s\n", name.c_str());
    } else if (asked_.starts_with(only)) {
      const std::string text = item(asked_.substr(only.size())).second();
      std::fwrite(text.data(), 1, text.size(), stdout);
    } else {
      return true;
    }
    return false;
  }

  /// The result of an item.
  std::string result(const std::string& name) const {
    const auto& found = item(name);
    if (!asked_.starts_with(from)) return found.second();
    const std::filesystem::path folder = asked_.substr(from.size());
    const std::string number = std::to_string(&found - items_.data());
    std::istringstream errors(content(folder / (number + ".errors")));
    for (std::string line; std::getline(errors, line);)  // "expected, but not so: ..."
      expect(false, line.c_str() + line.find(": ") + 2);
    return content(folder / (number + ".txt"));
  }

 private:
  using Item = std::pair<std::string, std::function<std::string()>>;
  static constexpr std::string_view only = "only ", from = "from ";

  const Item& item(std::string_view name) const {
    for (const Item& each : items_)
      if (each.first == name) return each;
    throw std::invalid_argument("no item is called " + std::string(name));
  }

  static std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::string asked_ = std::getenv("TUMBLE_ITEMS") ? std::getenv("TUMBLE_ITEMS") : "";
  std::vector<Item> items_;
};

/// The words and numbers of an item's result, which tabs and lines' ends separate.
inline std::vector<std::vector<std::string>> cells_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  return rows;
}

}  // namespace tumble::support
