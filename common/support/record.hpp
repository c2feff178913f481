/// @file
/// Where a chapter's program leaves what the book shows: numbers for the prose, tables for figures
/// and pages.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tumble::support {

/// `value` as printf would write it, for example number("%.3g", 0.000123).
inline std::string number(const char* format, double value) {
  char buffer[64];
  const int length = std::snprintf(buffer, sizeof buffer, format, value);
  if (length < 0 || length >= static_cast<int>(sizeof buffer))
    throw std::length_error("a number of over 63 characters");
  return buffer;
}

/// `value` with every digit it has, so that reading it back gives the same number.
inline std::string number(double value) {
  return number("%.17g", value);
}

/// A table in a file: one row of column names with their units, then rows of numbers or words,
/// separated by tabs. gnuplot draws from it and the book prints it.
class Table {
 public:
  Table(const std::filesystem::path& file, std::initializer_list<std::string_view> columns)
      : out_(file) {
    if (!out_) throw std::runtime_error("cannot write " + file.string());
    write(columns);
  }

  /// One row; each cell is a number or a text.
  template <class... Cells>
  void row(const Cells&... cells) {
    if (sizeof...(cells) != columns_)
      throw std::invalid_argument("a row with another number of cells than columns");
    write({std::string_view(text(cells))...});
  }

 private:
  static std::string text(double cell) { return number(cell); }
  static std::string text(std::string_view cell) { return std::string(cell); }

  void write(std::initializer_list<std::string_view> cells) {
    columns_ = cells.size();
    const char* separator = "";
    for (const std::string_view cell : cells) {
      out_ << separator << cell;
      separator = "\t";
    }
    out_ << '\n';
  }

  std::ofstream out_;
  std::size_t columns_ = 0;
};

/// The notebook of one program: opened with main's arguments, of which the one allowed is the
/// folder to write into. Without it that is the program's own folder, so that nothing is left where
/// the caller happens to be. The numbers go to PROGRAM.values.tsv.
class Notebook {
 public:
  Notebook(int argument_count, char** arguments)
      : folder_(argument_count > 1 ? std::filesystem::path(arguments[1])
                                   : std::filesystem::path(arguments[0]).parent_path() / "."),
        values_(file_in_folder(std::filesystem::path(arguments[0]).filename() += ".values.tsv"),
                {"name", "value"}) {}

  /// A number that the prose quotes by `name`, already in the form a reader should see.
  void value(std::string_view name, std::string_view shown) { values_.row(name, shown); }

  /// A table named `name`.tsv.
  Table table(std::string_view name, std::initializer_list<std::string_view> columns) const {
    return {file_in_folder(std::filesystem::path(name) += ".tsv"), columns};
  }

  /// Where to write a file called `name`; its folder is there from now on.
  std::filesystem::path file_in_folder(const std::filesystem::path& name) const {
    std::filesystem::create_directories(folder_);
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
  Table values_;
};

/// Unless `fact` holds, says so, and the program will end with a failure: a program that shows a
/// mistake asserts that it still fails in the way the page says. It goes on nevertheless, so that
/// the page has numbers and tables to show beside what is wrong.
inline void expect(bool fact, const char* sentence) {
  if (fact) return;
  std::fprintf(stderr, "expected, but not so: %s\n", sentence);
  [[maybe_unused]] static const int at_the_end = std::atexit([] {
    std::fflush(nullptr);
    std::_Exit(EXIT_FAILURE);
  });
}

}  // namespace tumble::support
