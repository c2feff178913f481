/// @file
/// A page that replays the motion.
#pragma once

#include <algorithm>
#include <support/player_page.hpp>

#include "drawn_scene.hpp"
#include "options.hpp"
#include "output_file.hpp"

namespace tumble::simulate {

class View {
  static constexpr double most_poses = 2e6;  // the page then has about a hundred megabytes

 public:
  /// `followed`: the body that the camera goes with, or an empty name.
  /// @throws FileError if the page would hold too much, or can't be written; UsageError if no body
  /// has that name.
  template <class Real, class Backend>
  View(const std::filesystem::path& path, const Scene<Real, Backend>& scene, std::int64_t every,
       std::int64_t steps, const std::string& followed)
      : file_(path),
        recording_(scene.title,
                   time_step_of<double>(scene.world.step_length()) * static_cast<double>(every)) {
    const std::int64_t frames = steps / every + 1;
    const double poses =
        static_cast<double>(scene.world.body_count()) * static_cast<double>(frames);
    if (poses > most_poses)
      throw FileError(path, "it would hold " + text_of(poses) + " poses, and a page with over " +
                                text_of(most_poses) + " is slow; record fewer with --every");
    draw(scene, recording_);
    if (!followed.empty()) recording_.follow(number_of(scene, followed));
  }

  template <class Real, class Backend>
  void record(const Scene<Real, Backend>& scene) {
    recording_.add_frame(drawn_poses(scene));
  }

  void finish() {
    file_.write(support::player_page(recording_.json()));
    file_.finish();
  }
  OutputFile& file() { return file_; }

 private:
  template <class Real, class Backend>
  static int number_of(const Scene<Real, Backend>& scene, const std::string& followed) {
    std::vector<std::string> names;
    for_each_body(scene,
                  [&](const std::string& name, const BodyRecord&) { names.push_back(name); });
    const auto found = std::find(names.begin(), names.end(), followed);
    if (found == names.end())
      throw UsageError("--follow is " + followed + "; no body has that name" +
                       did_you_mean(followed, {names.begin(), names.end()}));
    return static_cast<int>(found - names.begin());
  }

  OutputFile file_;
  support::Recording recording_;
};

}  // namespace tumble::simulate
