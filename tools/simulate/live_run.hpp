/// @file
/// A scene that a page edits and runs: what is kept of it while it is computed, part by part.
#pragma once

#include <support/scene_rules.hpp>
#include <tumble/ledger.hpp>
#include <tumble/scene/read_scene.hpp>

#include "close_approaches.hpp"
#include "drawn_scene.hpp"
#include "live_limits.hpp"
#include "parts_of_step.hpp"
#include "steps_until.hpp"

namespace tumble::simulate {

/// One simulation, with its books and what is drawn of it.
class LiveRun {
  static constexpr double most_poses = 4e5;  // some 20 megabytes
  static constexpr double most_frames = 2000;

 public:
  /// @throws SceneError and UsageError, as simulate does. `file` is what errors call the text.
  LiveRun(std::string text, std::string file)
      : text_(std::move(text)),
        file_(std::move(file)),
        scene_(read_scene<double, OneByOne<double>, support::SceneRules>(text_, file_)),
        ledger_(scene_.world),
        approaches_(scene_.world),
        steps_(steps_until(scene_)) {
    require_drawable(scene_);
    scene_.world.on_warning([](const std::string&) {});  // the plan has them
    const auto steps = static_cast<double>(steps_);
    const double poses = steps * static_cast<double>(scene_.world.body_count());
    every_ = std::llround(std::ceil(std::max(poses / most_poses, steps / most_frames)));
    start_ = scene_.world;
    record();
  }

  bool is_of(const std::string& text, const std::string& file) const {
    return text == text_ && file == file_;
  }
  bool is_complete() const { return scene_.world.ticks() == steps_; }

  /// Takes so many steps that a page has time for a picture in between.
  /// @throws SimulationError
  void go_on() {
    const auto bodies = static_cast<std::int64_t>(scene_.world.body_count());
    const std::int64_t steps = std::max<std::int64_t>(1, bodies_of_a_part / bodies);
    for (std::int64_t n = 0; n < steps && !is_complete(); ++n) {
      if (const std::string said = approaches_.look(scene_.world); !said.empty()) warning_ = said;
      ledger_.step(scene_.world);
      if (scene_.world.ticks() % every_ == 0) record();
    }
  }

  Scene<double>& scene() { return scene_; }
  /// The plan at the end, with a warning where a body came too close to a point that attracts.
  Plan plan() const {
    Plan plan = scene_.world.plan();
    const std::string summary = approaches_.summary(scene_.world);
    if (!warning_.empty()) plan.warnings.push_back(summary.empty() ? warning_ : summary);
    return plan;
  }
  const Ledger<double>& ledger() const { return ledger_; }
  std::int64_t steps() const { return steps_; }
  std::int64_t every() const { return every_; }  ///< steps from one frame to the next
  double time_step() const { return time_step_of<double>(scene_.world.step_length()); }

  /// Of each frame.
  struct Frames {
    std::vector<double> times, poses, kinetic, stored;  ///< s; 7 numbers a body; J; J
  };
  const Frames& frames() const { return frames_; }

  /// Runs one line of the plan alone, on copies of the bodies as they are at the start: `rounds`
  /// copies, and `steps` times on each, at most as many as are known to succeed. Part -1 is the
  /// whole step. Whoever calls it holds the clock.
  void run_part(int part, int rounds, int steps) const {
    const StepTime<double> moment = start_.step_time();
    const std::int64_t most = std::min<std::int64_t>(steps, steps_);
    const std::vector<PartOfStep> parts = parts_of(start_.step_plan());
    for (int round = 0; round < rounds; ++round) {
      if (part < 0) {
        World<double> world = start_;
        for (std::int64_t n = 0; n < most; ++n) world.step();
      } else {
        Bodies<double> bodies = start_.bodies();
        const PartOfStep& one = parts[static_cast<std::size_t>(part)];
        for (std::int64_t n = 0; n < most * one.times; ++n) one.act(bodies, moment);
      }
    }
  }
  int part_count() const { return static_cast<int>(parts_of(start_.step_plan()).size()); }

 private:
  static constexpr std::int64_t bodies_of_a_part = 200;

  void record() {
    frames_.times.push_back(static_cast<double>(scene_.world.ticks()) * time_step());
    for (const Posed& pose : drawn_poses(scene_)) {
      for (const double length : pose.position) frames_.poses.push_back(length);
      frames_.poses.push_back(pose.orientation.real);
      for (const double part : pose.orientation.imaginary) frames_.poses.push_back(part);
    }
    frames_.kinetic.push_back(holdings_of(scene_.world.bodies()).energy);
    frames_.stored.push_back(stored_energy(scene_.world));
  }

  std::string text_, file_;
  Scene<double> scene_;
  Ledger<double> ledger_;
  CloseApproaches<double> approaches_;
  std::string warning_;  ///< the first one
  std::int64_t steps_, every_ = 1;
  World<double> start_;
  Frames frames_;
};

}  // namespace tumble::simulate
