/// @file
/// The books as JSON, for programs: what the table prints with three digits, with all of them.
#pragma once

#include <support/json_text.hpp>
#include <tumble/ledger.hpp>
#include <tumble/scene/scene.hpp>

namespace tumble::simulate {

/// A number of JSON; what is not finite has none and becomes null.
inline std::string json_number(double number) {
  return std::isfinite(number) ? text_of(number) : "null";
}

/// The amounts of a line: J, kg m/s, and kg m²/s about the origin, world axes.
inline std::string json_of(const LedgerLine& line) {
  std::string text = "\"energy\":" + json_number(line.energy);
  const auto list = [&](const char* key, const Vec3d& vector) {
    text.append(",\"").append(key).append("\":[").append(json_number(vector.x())).append(",");
    text.append(json_number(vector.y())).append(",").append(json_number(vector.z())).append("]");
  };
  list("momentum", line.momentum);
  list("angular_momentum", line.angular_momentum);
  return text;
}

/// The whole books, with the energy (J) that gravity and springs store.
template <class Real, class Backend>
std::string books_of(const Ledger<Real>& ledger, Scene<Real, Backend>& scene) {
  const World<Real, Backend>& world = scene.world;
  const double h = time_step_of<double>(world.step_length());
  std::string text = "{\"bodies\":" + std::to_string(world.body_count());
  text.append(",\"turning_method\":").append(support::json_text(world.turning_method()));
  text.append(",\"scheme\":").append(support::json_text(name_of(world.scheme())));
  text.append(",\"steps\":").append(std::to_string(world.ticks()));
  text.append(",\"time_step\":").append(json_number(h));
  text.append(",\"time\":").append(json_number(static_cast<double>(world.ticks()) * h));
  text.append(",\"stored_at_the_start\":").append(json_number(ledger.stored_at_start()));
  text.append(",\"stored_now\":").append(json_number(stored_energy(scene.world)));
  text.append(",\n\"at_the_start\":{").append(json_of(ledger.start()));
  text.append("},\n\"effects\":[");
  const char* comma = "\n";
  for (const LedgerLine& line : ledger.lines()) {
    text.append(comma).append("{\"name\":").append(support::json_text(line.name)).append(",");
    text.append(json_of(line)).append("}");
    comma = ",\n";
  }
  text.append("],\n\"now\":{").append(json_of(ledger.now(world)));
  return text.append("},\n\"unexplained\":{").append(json_of(ledger.rest(world))).append("}}\n");
}

}  // namespace tumble::simulate
