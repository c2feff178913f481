/// @file
/// Where every body was at each recorded moment, as CSV or as JSON Lines.
#pragma once

#include <nlohmann/json.hpp>
#include <tumble/scene/scene.hpp>

#include "output_file.hpp"

namespace tumble::simulate {

/// A body as the file shows it: the centre of mass, and the orientation of the model, not that of
/// the principal axes, which nobody sees. World axes.
struct BodyRecord {
  Vec3d position, velocity, angular_velocity;
  Quaternion<double> orientation;
};

template <class Real>
BodyRecord record_of(const RigidBody<Real>& body, const Posed& model_in_body) {
  const Quaternion<double> q{static_cast<double>(body.top.orientation.real),
                             body.top.orientation.imaginary.template cast<double>()};
  return {body.centre.position.template cast<double>(),
          body.centre.velocity.template cast<double>(),
          angular_velocity_world(body.top).template cast<double>(), q * model_in_body.orientation};
}

/// Calls `visit` with each body's name and record.
template <class Real, class Keeping, class Visit>
void for_each_body(const Scene<Real, Keeping>& scene, const Visit& visit) {
  for (const BodyModel& model : scene.models)
    for (std::size_t i = model.first; i < model.first + model.count; ++i) {
      const BodyHandle handle = scene.world.handle_at(static_cast<BodyIndex>(i));
      visit(scene.world.name_of(handle), record_of(scene.world.body(handle), model.model_in_body));
    }
}

inline std::array<double, 13> numbers_of(const BodyRecord& body) {
  const auto& [x, v, w, q] = body;
  return {x.x(),           x.y(),           x.z(), q.real, q.imaginary.x(),
          q.imaginary.y(), q.imaginary.z(), v.x(), v.y(),  v.z(),
          w.x(),           w.y(),           w.z()};
}

/// A name as a cell of CSV (RFC 4180).
inline std::string cell(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
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

  template <class Real, class Keeping>
  void record(double time, const Scene<Real, Keeping>& scene) {
    std::string text;
    for_each_body(scene, [&](const std::string& name, const BodyRecord& body) {
      text.append(text_of(time)).append(",").append(cell(name));
      for (const double number : numbers_of(body)) text.append(",").append(text_of(number));
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

  template <class Real, class Keeping>
  void record(double time, const Scene<Real, Keeping>& scene) {
    std::string text;
    for_each_body(scene, [&](const std::string& name, const BodyRecord& body) {
      const std::array<double, 13> numbers = numbers_of(body);
      text.append("{\"time\":").append(text_of(time));
      text.append(",\"body\":").append(nlohmann::json(name).dump());
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
