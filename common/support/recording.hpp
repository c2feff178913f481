/// @file
/// Writes down how bodies moved, for the player that replays it: their shapes once, then their
/// poses at equal intervals of time, as JSON.
#pragma once

#include <array>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>
#include <support/json_text.hpp>
#include <tumble/require.hpp>
#include <vector>

namespace tumble::support {

/// Numbers with the digits that a float has: more than a picture can show.
/// @throws std::invalid_argument with `name` and `unit` if one is not finite, as a float.
inline std::string json_numbers(std::string_view name, std::string_view unit,
                                std::initializer_list<double> numbers) {
  std::string json;
  for (const double number : numbers) {
    if (!std::isfinite(static_cast<float>(number)))
      reject(name, number, unit, "a recording holds finite floats only");
    if (!json.empty()) json += ',';
    json += text_of(static_cast<float>(number));
  }
  return json;
}

/// A solid to draw, centred as in chapter 3; lengths in m, in the model's axes.
class Part {
 public:
  static Part box(const Vec3d& size) { return solid("box", {size.x(), size.y(), size.z()}); }
  static Part sphere(double radius) {
    return Part("\"sphere\":" + lengths("radius of the sphere", {radius}));
  }
  static Part cylinder(double radius, double height) { return solid("cylinder", {radius, height}); }
  static Part capsule(double radius, double length) { return solid("capsule", {radius, length}); }
  static Part cone(double radius, double height) { return solid("cone", {radius, height}); }
  static Part ellipsoid(const Vec3d& semi_axes) {
    return solid("ellipsoid", {semi_axes.x(), semi_axes.y(), semi_axes.z()});
  }
  static Part point() { return Part("\"point\":true"); }

  /// @throws std::invalid_argument if a triangle names a corner that is not there.
  static Part mesh(const std::vector<Vec3d>& corners,
                   const std::vector<std::array<int, 3>>& triangles) {
    std::string json = "\"mesh\":{\"corners\":[";
    const char* comma = "";
    for (const Vec3d& corner : corners) {
      json.append(comma).append("[").append(
          json_numbers("corner of the mesh", "m", {corner.x(), corner.y(), corner.z()}));
      json += ']';
      comma = ",";
    }
    json += "],\"triangles\":[";
    comma = "";
    for (const auto& [a, b, c] : triangles) {
      for (const int corner : {a, b, c})
        if (corner < 0 || static_cast<std::size_t>(corner) >= corners.size())
          throw std::invalid_argument("a triangle of the mesh names corner " +
                                      std::to_string(corner) + "; it has " +
                                      std::to_string(corners.size()) + ", counted from 0");
      json.append(comma).append("[").append(std::to_string(a)).append(",");
      json.append(std::to_string(b)).append(",").append(std::to_string(c)).append("]");
      comma = ",";
    }
    return Part(json + "]}");
  }

  /// The same solid, moved in the model's axes. `Pose` is chapter 5's.
  template <class Pose>
  Part at(const Pose& pose) const {
    const auto& [real, imaginary] = pose.orientation;
    return Part(json_ + ",\"position\":[" +
                json_numbers("position of a part", "m",
                             {pose.position.x(), pose.position.y(), pose.position.z()}) +
                "],\"orientation\":[" +
                json_numbers("orientation of a part", "",
                             {real, imaginary.x(), imaginary.y(), imaginary.z()}) +
                "]");
  }

  std::string json() const { return "{" + json_ + "}"; }

 private:
  explicit Part(std::string json) : json_(std::move(json)) {}

  static std::string lengths(const std::string& name, std::initializer_list<double> values) {
    for (const double value : values)
      if (!(value >= 0)) reject(name, value, "m", "it must be 0 or more");
    return json_numbers(name, "m", values);
  }

  static Part solid(const std::string& kind, std::initializer_list<double> values) {
    return Part("\"" + kind + "\":[" + lengths("length of the " + kind, values) + "]");
  }

  std::string json_;
};

/// One end of a link: a point (m) in a body's model axes, or in the world's.
struct LinkEnd {
  Vec3d point;
  int body = -1;  ///< as add_body() counted it; -1: none, the point is one of the world
};

/// Bodies and how they moved.
class Recording {
 public:
  /// @throws std::invalid_argument unless `seconds_between_frames` is finite and greater than 0.
  Recording(std::string_view title, double seconds_between_frames) {
    if (!(seconds_between_frames > 0))
      reject("time between frames", seconds_between_frames, "s", "it must be greater than 0");
    require_finite("time between frames", seconds_between_frames, "s");
    head_ = "{\"title\":" + json_text(title) +
            ",\"seconds_between_frames\":" + text_of(seconds_between_frames);
  }

  /// A body and what it is made of; returns its number, counted from 0.
  /// @throws std::logic_error once there are frames, which would lack its pose.
  int add_body(std::string_view name, const std::vector<Part>& parts) {
    if (!frames_.empty())
      throw std::logic_error("body \"" + std::string(name) +
                             "\" comes after the first frame; bodies come before all frames");
    bodies_ += (bodies_.empty() ? "{\"name\":" : ",{\"name\":") + json_text(name) + ",\"parts\":[";
    for (std::size_t n = 0; n < parts.size(); ++n)
      bodies_.append(n == 0 ? "" : ",").append(parts[n].json());
    bodies_ += "]}";
    return static_cast<int>(body_count_++);
  }

  /// A line between two points, such as a spring.
  void add_link(const LinkEnd& from, const LinkEnd& to) {
    const std::string both = json(from) + ",\"to\":" + json(to);
    links_.append(links_.empty() ? "{\"from\":" : ",{\"from\":").append(both).append("}");
  }

  /// The player's camera goes with this body from the start, as add_body() counted it.
  /// @throws std::invalid_argument if there is none of that number.
  void follow(int body) {
    if (body < 0 || static_cast<std::size_t>(body) >= body_count_)
      throw std::invalid_argument("the camera is to follow body " + std::to_string(body) +
                                  "; there are " + std::to_string(body_count_) +
                                  ", counted from 0");
    followed_ = ",\"follow\":" + std::to_string(body);
  }

  /// The drawn pose of every body's model, in the order of the bodies. `Poses` is a list of chapter
  /// 5's poses.
  /// @throws std::invalid_argument if their number is another than that of the bodies, or if one is
  /// not finite; the recording is then unchanged.
  template <class Poses>
  void add_frame(const Poses& poses) {
    if (std::size(poses) != body_count_)
      throw std::invalid_argument("a frame with " + std::to_string(std::size(poses)) +
                                  " poses; it must have one for each of the " +
                                  std::to_string(body_count_) + " bodies");
    std::string frame = frames_.empty() ? "[" : ",[";
    const char* comma = "";
    for (const auto& [position, orientation] : poses) {
      const auto& [real, imaginary] = orientation;
      frame.append(comma).append(
          json_numbers("position in a frame", "m", {position.x(), position.y(), position.z()}));
      frame.append(",").append(json_numbers("orientation in a frame", "",
                                            {real, imaginary.x(), imaginary.y(), imaginary.z()}));
      comma = ",";
    }
    frames_.append(frame).append("]");
  }

  std::string json() const {
    return head_ + followed_ + ",\"bodies\":[" + bodies_ + "],\"links\":[" + links_ +
           "],\"frames\":[" + frames_ + "]}\n";
  }

  /// @throws std::runtime_error if the file can't be written.
  void write(const std::string& file) const {
    const std::string text = json();
    std::FILE* out = std::fopen(file.c_str(), "wb");
    const bool is_written = out && std::fwrite(text.data(), 1, text.size(), out) == text.size();
    const bool is_closed = out && std::fclose(out) == 0;
    if (!is_written || !is_closed) throw std::runtime_error("cannot write " + file);
  }

 private:
  std::string json(const LinkEnd& end) const {
    std::string json = "{";
    if (end.body != -1) {
      if (end.body < 0 || static_cast<std::size_t>(end.body) >= body_count_)
        throw std::invalid_argument("a link names body " + std::to_string(end.body) +
                                    "; there are " + std::to_string(body_count_) +
                                    ", counted from 0");
      json.append("\"body\":").append(std::to_string(end.body)).append(",");
    }
    return json + "\"point\":[" +
           json_numbers("end of a link", "m", {end.point.x(), end.point.y(), end.point.z()}) + "]}";
  }

  std::string head_, followed_, bodies_, links_, frames_;
  std::size_t body_count_ = 0;
};

}  // namespace tumble::support
