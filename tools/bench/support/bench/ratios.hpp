/// @file
/// From times to ratios: who takes how often as long as whom.
#pragma once

#include <support/bench/contenders.hpp>
#include <support/record.hpp>

namespace tumble::support::bench {

/// A number that may not have been measured.
using Maybe = std::optional<double>;

inline Maybe ratio(Maybe a, Maybe b) {
  if (!a || !b) return {};
  return *a / *b;
}

/// As a reader should see it; nothing where nothing was measured.
inline std::string shown(Maybe value, const char* format = "%.3g") {
  return value ? number(format, *value) : "";
}

/// The same for a sentence, which the book leaves out where there is nothing to say.
inline std::string said(Maybe value, const char* format = "%.2g") {
  return shown(value, format);
}

/// What the tables ask of the measurements.
class Ratios {
 public:
  explicit Ratios(const Measurements& measurements) : measurements_(measurements) {}

  /// ns per body and step with everything on.
  Maybe time(const std::string& contender, std::size_t count, int threads = 1,
             const std::string& precision = "float") const {
    return measurements_.time({contender, Scene::everything, precision, count, threads});
  }
  Maybe time(const std::string& contender, Scene scene, std::size_t count,
             const std::string& precision = "float") const {
    return measurements_.time({contender, scene, precision, count, 1});
  }

  /// Bytes read and written in a ns, that is GB/s, by the faster of the two loops, in arrays as
  /// large as those of `count` bodies.
  Maybe bandwidth(std::size_t count, int threads = 1) const {
    const std::size_t bytes = bytes_of_bodies(count);
    const Maybe update = time(memory_update, count, threads);
    const Maybe triad = time(memory_triad, count, threads);
    if (!update || !triad) return {};
    return std::max(Memory<Stream::update>::moved(bytes) / *update,
                    Memory<Stream::triad>::moved(bytes) / *triad) /
           static_cast<double>(count);
  }

  /// The part of that bandwidth which a contender uses that must move `bytes` per body and step.
  Maybe share_of_bandwidth(double bytes, Maybe contender_time, std::size_t count,
                           int threads = 1) const {
    const Maybe used = ratio(bytes, contender_time);
    return ratio(used, bandwidth(count, threads));
  }

 private:
  const Measurements& measurements_;
};

}  // namespace tumble::support::bench
