/// @file
/// Programs that try what cannot be, and print the sentence that it gets.
#pragma once

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <support/record.hpp>

namespace tumble::support {

/// Prints `text` indented, in lines short enough for a page.
inline void print_wrapped(const std::string& text) {
  const std::string indent = "    ";
  std::istringstream words(text);
  std::string line = indent, word;
  while (words >> word) {
    if (line.size() + 1 + word.size() > 88) {
      std::printf("%s\n", line.c_str());
      line = indent;
    }
    line.append(line == indent ? "" : " ").append(word);
  }
  std::printf("%s\n", line.c_str());
}

/// Does `action`, prints what was tried and what came of it, and returns the sentence with which it
/// was refused, empty if it was not.
template <class Action>
std::string refusal(const char* what, const Action& action) {
  std::string sentence;
  std::printf("%s\n", what);
  try {
    action();
  } catch (const std::invalid_argument& error) {
    sentence = error.what();
  }
  print_wrapped(sentence.empty() ? "is taken" : sentence);
  return sentence;
}

/// The same; returns 1 if it was refused.
template <class Action>
int try_it(const char* what, const Action& action) {
  return !refusal(what, action).empty();
}

/// The same, and makes a row of a table_of_refusals. The function called is `who`.
template <class Action>
int try_it(Table& table, const char* what, const char* who, const Action& action) {
  const std::string sentence = refusal(what, action);
  const bool is_refused = !sentence.empty();
  table.row(what, is_refused ? who : "nobody", is_refused ? sentence : "(taken)");
  return is_refused;
}

/// A table of what cannot be.
inline Table table_of_refusals(const Notebook& notebook, std::string_view name) {
  return notebook.table(name, {"what came in", "who refuses it", "the sentence"});
}

}  // namespace tumble::support
