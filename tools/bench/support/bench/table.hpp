/// @file
/// A table of numbers: for the terminal, and for the book.
#pragma once

#include <algorithm>
#include <iostream>
#include <support/record.hpp>

namespace tumble::support::bench {

/// What a column is called: by a word in the terminal, in full in the book.
struct Heading {
  std::string brief, full;
};

/// The text with blanks before or after it, `width` letters in all. Of a letter that has several
/// bytes in UTF-8 all but the first begin with the bits 10.
inline std::string padded(const std::string& text, std::size_t width, bool is_number) {
  const auto letters = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
  const std::string blanks(letters < width ? width - letters : 0, ' ');
  return is_number ? blanks + text : text + blanks;
}

/// Prints a table and writes it to a file; each row is as long as the list of columns.
inline void show(const Notebook& notebook, std::string_view name, std::string_view title,
                 const std::vector<Heading>& columns,
                 const std::vector<std::vector<std::string>>& rows) {
  std::ofstream file(notebook.file_in_folder(std::string(name) + ".tsv"));
  std::size_t first = 22;
  for (const auto& row : rows) first = std::max(first, row.front().size());
  const auto print = [first](std::size_t column, const std::string& text) {
    std::cout << padded(text, column ? 10 : first, column > 0);
  };
  std::cout << '\n' << title << "\n\n";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    file << (i ? "\t" : "") << columns[i].full;
    print(i, columns[i].brief);
  }
  for (const auto& row : rows) {
    file << '\n';
    std::cout << '\n';
    for (std::size_t i = 0; i < row.size(); ++i) {
      file << (i ? "\t" : "") << row[i];
      print(i, row[i].empty() ? "-" : row[i]);
    }
  }
  file << '\n';
  std::cout << '\n';
}

}  // namespace tumble::support::bench
