/// @file
/// One simulation from the scene file to the last line.
#pragma once

#include <exception>
#include <tumble/scene/number_range.hpp>

#include "bill.hpp"
#include "books.hpp"
#include "close_approaches.hpp"
#include "interrupts.hpp"
#include "options.hpp"
#include "plot.hpp"
#include "progress.hpp"
#include "simulated_scene.hpp"
#include "steps_until.hpp"
#include "view.hpp"

namespace tumble::simulate {

/// Whatever was asked to be written.
struct Outputs {
  std::optional<CsvFile> csv;
  std::optional<JsonLinesFile> json_lines;
  std::optional<Plot> plot;
  std::optional<View> view;
  std::optional<OutputFile> books;

  template <class Real, class Backend>
  Outputs(const Options& options, const Scene<Real, Backend>& scene, std::int64_t steps) {
    if (!options.csv.empty()) csv.emplace(options.csv);
    if (!options.json_lines.empty()) json_lines.emplace(options.json_lines);
    if (!options.plot.empty()) plot.emplace(options.plot);
    if (!options.view.empty())
      view.emplace(options.view, scene, options.every, steps, options.follow);
    if (!options.books.empty()) books.emplace(options.books);
  }

  /// Records this moment. The page of a view has equal intervals only: it leaves out a last moment
  /// that comes early. What can't be recorded any further is given up, and the others go on.
  /// @throws what went wrong, once nothing is left.
  template <class Real, class Backend>
  void record(Scene<Real, Backend>& scene, bool comes_early = false) {
    const double time =
        static_cast<double>(scene.world.ticks()) * time_step_of<double>(scene.world.step_length());
    record_in(csv, [&] { csv->record(time, scene); });
    record_in(json_lines, [&] { json_lines->record(time, scene); });
    record_in(plot, [&] { plot->record(time, scene); });
    if (!comes_early) record_in(view, [&] { view->record(scene); });
  }

  /// Finishes all that can be finished, and then throws what went wrong first. If Ctrl-C ended the
  /// drawing, that is told here, and the caller ends as after any signal.
  void finish(const std::string& title, const std::string& text_of_books) {
    const auto attempt = [this](OutputFile& file, const auto& finish_file) {
      try {
        finish_file();
        std::printf("wrote %s\n", file.path().c_str());
      } catch (const std::exception& error) {
        if (failure_ || ended_by != 0)
          std::fprintf(stderr, "simulate: %s\n", error.what());
        else
          failure_ = std::current_exception();
      }
    };
    if (csv) attempt(csv->file(), [this] { csv->file().finish(); });
    if (json_lines) attempt(json_lines->file(), [this] { json_lines->file().finish(); });
    if (plot) attempt(plot->file(), [&] { plot->finish(title); });
    if (view) attempt(view->file(), [this] { view->finish(); });
    if (books)
      attempt(*books, [&] {
        books->write(text_of_books);
        books->finish();
      });
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <class Output, class Record>
  void record_in(std::optional<Output>& output, const Record& record_moment) {
    if (!output) return;
    const std::string path = output->file().path().string();
    try {
      record_moment();
    } catch (const std::exception& error) {
      output.reset();  // also what it holds of the disk or the memory
      if (!failure_) failure_ = std::current_exception();
      if (!csv && !json_lines && !plot && !view && !books) std::rethrow_exception(failure_);
      std::fprintf(stderr, "%ssimulate: %s is given up, and the other outputs go on: %s\n",
                   ::isatty(STDERR_FILENO) == 1 ? "\n" : "", path.c_str(), error.what());
    }
  }

  std::exception_ptr failure_;  ///< what went wrong first
};

/// Takes the steps. @return how it ended; `failure` says why, if a step failed
template <class Real, class Backend>
ExitCode take_steps(Scene<Real, Backend>& scene, Ledger<Real>& ledger, const Options& options,
                    std::int64_t steps, Outputs& outputs, CloseApproaches<Real>& approaches,
                    std::string& failure) {
  outputs.record(scene);
  Progress progress(steps);
  ExitCode code = all_simulated;
  bool is_recorded = true;
  for (std::int64_t step = 1; step <= steps; ++step) {
    if (const std::string said = approaches.look(scene.world); !said.empty())
      progress.say("warning: " + said);
    try {
      if (options.ledger)
        ledger.step(scene.world);
      else
        scene.world.step();
    } catch (const SimulationError& error) {
      failure = error.what();
      code = step_failed;
      break;
    }
    is_recorded = step % options.every == 0;
    if (is_recorded) outputs.record(scene);
    progress.show(step);
    if (ended_by != 0) {
      code = interrupted;
      break;
    }
  }
  if (!is_recorded) outputs.record(scene, true);
  progress.end();
  const double seconds = progress.seconds();
  std::printf("%lld steps in %.3g s: %.4g steps per second\n",
              static_cast<long long>(scene.world.ticks()), seconds,
              static_cast<double>(scene.world.ticks()) / seconds);
  return code;
}

template <class Real, class Backend>
void print_scene(Scene<Real, Backend>& scene, const Options& options, std::int64_t steps,
                 CloseApproaches<Real>& approaches) {
  std::printf("%s\n", scene.title.c_str());
  if (!scene.description.empty()) std::printf("%s\n", scene.description.c_str());
  std::printf("\n");
  if (!options.said.empty()) std::printf("%s\n", options.said.c_str());
  const double h = time_step_of<double>(scene.world.step_length());
  // A time step that was rounded to nanoseconds puts the end off by far less than this.
  const double duration = options.until.value_or(scene.duration);
  const double end = static_cast<double>(steps) * h;
  if (std::abs(end - duration) > h / 1000)
    std::printf("%.6g s are no whole number of steps: the last one ends at %.6g s\n", duration,
                end);
  const std::size_t bodies = scene.world.body_count();
  Plan plan = scene.world.plan();
  if (const std::string said = approaches.look(scene.world); !said.empty())
    plan.warnings.push_back(said);
  std::printf("%s, %lld steps of %.6g s, in %s\n\n%s\n",
              bodies == 1 ? "1 body" : (std::to_string(bodies) + " bodies").c_str(),
              static_cast<long long>(steps), h, std::string(range_of<Real>().precision).c_str(),
              table_of(plan).c_str());
  std::fflush(stdout);
}

/// @throws UsageError, SceneError, FileError.
template <class Real>
ExitCode run(const Options& options) {
  using Backend = InPacks<Real>;
  SceneInPacks<Real> scene = scene_of<Real>(options);
  const std::int64_t steps = steps_until(scene, options.until);
  scene.world.on_warning([](const std::string&) {});  // they stand below the plan
  CloseApproaches<Real> approaches(scene.world);
  if (options.only_plan) {
    print_scene(scene, options, steps, approaches);
    return all_simulated;
  }
  catch_signals();
  Outputs outputs(options, scene, steps);
  print_scene(scene, options, steps, approaches);
  const World<Real, Backend> start = scene.world;
  scene.world.use_threads(options.threads);
  Ledger<Real> ledger(scene.world);
  std::string failure;
  const ExitCode code = take_steps(scene, ledger, options, steps, outputs, approaches, failure);
  if (code == step_failed) std::fprintf(stderr, "simulate: %s\n", failure.c_str());
  if (code == interrupted)
    std::printf("interrupted after %lld of %lld steps\n",
                static_cast<long long>(scene.world.ticks()), static_cast<long long>(steps));
  if (options.ledger) std::printf("\n%s", table_of(ledger, scene.world).c_str());
  if (const std::string said = approaches.summary(scene.world); !said.empty())
    std::printf("warning: %s\n", said.c_str());
  if (options.bill && code == all_simulated)
    std::printf("\n%s", Bill<Real, Backend>(start, steps).table().c_str());
  outputs.finish(scene.title, outputs.books ? books_of(ledger, scene) : std::string());
  return ended_by != 0 ? static_cast<ExitCode>(interrupted + ended_by) : code;
}

}  // namespace tumble::simulate
