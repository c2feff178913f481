/// @file
/// Paths and energies as a figure, drawn by gnuplot like the figures of the book.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <support/record.hpp>
#include <tumble/ledger.hpp>

#include "interrupts.hpp"
#include "paths.hpp"
#include "trajectory.hpp"

namespace tumble::simulate {

/// A text as one word of a shell.
inline std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char letter : text)
    word += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return word + "'";
}

/// A folder that vanishes with this object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "tumble-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw FileError(name, "no folder for what gnuplot draws from");
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Collects and draws. Of many bodies it draws the paths of some, at equal distances in the list.
class Plot {
  static constexpr std::size_t most_paths = 6;

 public:
  /// @throws FileError without gnuplot or a folder for its tables, or if the file can't be written.
  explicit Plot(const std::filesystem::path& path) : file_(path) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
      throw FileError(path,
                      "gnuplot draws it and is not installed (Debian's package is gnuplot-nox)");
    std::error_code missing;
    if (std::filesystem::temp_directory_path(missing).empty())
      throw FileError(path, "there is no folder for temporary files; TMPDIR names it");
  }

  template <class Real, class Backend>
  void record(double time, Scene<Real, Backend>& scene) {
    const std::size_t count = scene.world.body_count();
    const double kinetic = holdings_of(scene.world.bodies()).energy;
    energies_.push_back({time, kinetic, stored_energy(scene.world)});
    for (std::size_t k = 0; k < std::min(count, most_paths); ++k) {
      const auto body = static_cast<BodyIndex>(count <= most_paths ? k : k * count / most_paths);
      const BodyHandle handle = scene.world.handle_at(body);
      if (energies_.size() == 1) paths_.push_back({scene.world.name_of(handle), {}});
      paths_[k].points.push_back(scene.world.position(handle).template cast<double>());
    }
  }

  /// Draws and gives the file its name.
  void finish(const std::string& title) {
    const ScratchFolder scratch;
    const auto [across, up] = widest_axes();
    write_tables(scratch.path(), across, up);
    const char* names = "xyz";
    const std::string command =
        "cd " + shell_word(scratch.path().string()) + " && gnuplot -e \"name='figure'\" " +
        shell_word(figure_style().string()) + " -e " +
        shell_word("paths=" + std::to_string(paths_.size()) + "; across='" + names[across] +
                   "'; up='" + names[up] + "'; scene=" + gnuplot_text(title)) +
        " " + shell_word(plot_script().string()) + " 2>gnuplot.log";
    const int status = std::system(command.c_str());
    // A program that waits for a shell is deaf to Ctrl-C; the shell and gnuplot are not.
    if ((WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) ||
        (WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT)) {
      ended_by = SIGINT;
      throw FileError(file_.path(), "gnuplot was interrupted");
    }
    if (status != 0) {
      std::ifstream log(scratch.path() / "gnuplot.log");
      throw FileError(file_.path(),
                      "gnuplot says: " + std::string(std::istreambuf_iterator<char>(log), {}));
    }
    std::ifstream drawn(scratch.path() / "figure.svg");
    file_.write({std::istreambuf_iterator<char>(drawn), {}});
    file_.finish();
  }
  OutputFile& file() { return file_; }

 private:
  struct Energies {
    double time, kinetic, stored;
  };
  struct Path {
    std::string body;
    std::vector<Vec3d> points;
  };

  static std::string gnuplot_text(const std::string& text) {
    std::string quoted = "'";
    for (const char letter : text)
      quoted.append(letter == '\'' ? 2 : 1, letter == '\n' ? ' ' : letter);
    return quoted + "'";
  }

  /// The two axes along which the paths reach farthest, in their order.
  std::pair<int, int> widest_axes() const {
    Vec3d low = paths_[0].points[0], high = low;
    for (const Path& path : paths_)
      for (const Vec3d& point : path.points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
      }
    Eigen::Index least = 0;
    (high - low).reverse().minCoeff(&least);  // of equals keep x and z
    least = 2 - least;
    if ((high - low).y() == (high - low).minCoeff()) least = 1;
    return {least == 0 ? 1 : 0, least == 2 ? 1 : 2};
  }

  void write_tables(const std::filesystem::path& folder, int across, int up) const {
    support::Table energy(folder / "energy.tsv", {"time (s)", "kinetic", "stored", "sum"});
    for (const auto& [time, kinetic, stored] : energies_)
      energy.row(time, kinetic, stored, kinetic + stored);
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      std::string name = paths_[k].body;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == '\t' || c == '\n' || c == '"'; }, ' ');
      support::Table path(folder / ("path" + std::to_string(k + 1) + ".tsv"), {"across", name});
      for (const Vec3d& point : paths_[k].points) path.row(point[across], point[up]);
    }
  }

  OutputFile file_;
  std::vector<Energies> energies_;
  std::vector<Path> paths_;
};

}  // namespace tumble::simulate
