/// @file
/// Where every body was at each recorded moment, as CSV or as JSON Lines.
#pragma once

#include <support/json_text.hpp>

#include "body_record.hpp"
#include "output_file.hpp"

namespace tumble::simulate {

/// A name as a cell of CSV (RFC 4180).
inline std::string cell(const std::string& name) {
  if (name.find_first_of(",\"\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char letter : name) quoted.append(letter == '"' ? 2 : 1, letter);
  return quoted + '"';
}

class CsvFile {
 public:
  explicit CsvFile(const std::filesystem::path& path) : file_(path) {
    file_.write(
        "time (s),body,position x (m),position y (m),position z (m),orientation w,orientation x,"
        "orientation y,orientation z,velocity x (m/s),velocity y (m/s),velocity z (m/s),"
        "angular velocity x (rad/s),angular velocity y (rad/s),angular velocity z (rad/s)\n");
  }

  template <class Real, class Backend>
  void record(double time, const Scene<Real, Backend>& scene) {
    std::string text;
    for_each_body(scene, [&](const std::string& name, const BodyRecord& body) {
      text.append(text_of(time)).append(",").append(cell(name));
      for (const double number : state_of(body)) text.append(",").append(text_of(number));
      text += '\n';
    });
    file_.write(text);
  }
  OutputFile& file() { return file_; }

 private:
  OutputFile file_;
};

class JsonLinesFile {
 public:
  explicit JsonLinesFile(const std::filesystem::path& path) : file_(path) {}

  template <class Real, class Backend>
  void record(double time, const Scene<Real, Backend>& scene) {
    std::string text;
    for_each_body(scene, [&](const std::string& name, const BodyRecord& body) {
      const std::array<double, 13> numbers = state_of(body);
      text.append("{\"time\":").append(text_of(time));
      text.append(",\"body\":").append(support::json_text(name));
      const auto list = [&](const char* key, std::size_t first, std::size_t last) {
        text.append(",\"").append(key).append("\":");
        for (std::size_t i = first; i < last; ++i)
          text.append(i == first ? "[" : ",").append(text_of(numbers[i]));
        text += ']';
      };
      list("position", 0, 3);
      list("orientation", 3, 7);
      list("velocity", 7, 10);
      list("angular_velocity", 10, 13);
      text += "}\n";
    });
    file_.write(text);
  }
  OutputFile& file() { return file_; }

 private:
  OutputFile file_;
};

}  // namespace tumble::simulate
