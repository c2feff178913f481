/// @file
/// A page that replays the motion.
#pragma once

#include <support/player_page.hpp>

#include "drawn_scene.hpp"
#include "output_file.hpp"

namespace tumble::simulate {

class View {
  static constexpr double most_poses = 2e6;  // the page then has about a hundred megabytes

 public:
  /// @throws FileError if the page would hold too much, or can't be written.
  template <class Real, class Backend>
  View(const std::filesystem::path& path, const Scene<Real, Backend>& scene, std::int64_t every,
       std::int64_t steps)
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
  OutputFile file_;
  support::Recording recording_;
};

}  // namespace tumble::simulate
