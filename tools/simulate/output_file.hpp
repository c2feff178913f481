/// @file
/// A file that is whole or not there: it is written under another name and gets its own at the end.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace tumble::simulate {

/// A file can't be written.
class FileError : public std::runtime_error {
 public:
  FileError(const std::filesystem::path& path, const std::string& why)
      : std::runtime_error("cannot write " + path.string() + ": " + why) {}
};

class OutputFile {
 public:
  /// @throws FileError if `path` is something other than a file, or nothing can be written there.
  explicit OutputFile(const std::filesystem::path& path) : path_(checked_place(path)) {
    partial_ = path_;
    partial_ += ".partial-" + std::to_string(::getpid());
    out_.open(partial_, std::ios::binary | std::ios::trunc);
    if (!out_) throw FileError(path, std::generic_category().message(errno));
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (finished_) return;
    out_.close();
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
  }

  void write(const std::string& text) {
    if (!out_.write(text.data(), static_cast<std::streamsize>(text.size())))
      throw FileError(path_, "the disk may be full");
  }

  /// Gives the file its name.
  void finish() {
    out_.close();
    std::error_code error;
    if (out_) std::filesystem::rename(partial_, path_, error);
    if (!out_ || error) throw FileError(path_, error ? error.message() : "the disk may be full");
    finished_ = true;
  }

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& partial_path() const { return partial_; }

 private:
  /// Where `path` leads. @throws FileError
  static std::filesystem::path checked_place(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    try {
      const fs::path place = fs::weakly_canonical(fs::absolute(path));
      if (fs::is_directory(place)) throw FileError(path, "it is a directory");
      if (fs::exists(place) && !fs::is_regular_file(place))
        throw FileError(path, "it is no regular file");
      if (is_open(place))
        throw FileError(path, "it is open already, such as for what is printed, and would be lost");
      if (!fs::is_directory(place.parent_path()))
        throw FileError(path, "there is no directory " + place.parent_path().string());
      if (::access(fs::exists(place) ? place.c_str() : place.parent_path().c_str(), W_OK) != 0)
        throw FileError(path, "no permission");
      return place;
    } catch (const fs::filesystem_error& error) {  // a loop of links, a name that is too long
      throw FileError(path, error.code().message());
    }
  }

  /// Whether a descriptor that this program was given leads to the file.
  static bool is_open(const std::filesystem::path& place) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    for (const fs::directory_entry& descriptor : fs::directory_iterator("/proc/self/fd", ignored))
      if (fs::equivalent(descriptor.path(), place, ignored)) return true;
    return false;
  }

  std::filesystem::path path_, partial_;
  std::ofstream out_;
  bool finished_ = false;
};

}  // namespace tumble::simulate
