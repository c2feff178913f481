#include "output_file.hpp"

#include <fstream>
#include <sstream>
#include <support/checks.hpp>

using namespace tumble::simulate;
namespace fs = std::filesystem;

namespace {

/// A folder that is empty at first and gone at last.
class Scratch {
 public:
  Scratch() : place_(fs::temp_directory_path() / ("output-" + std::to_string(::getpid()))) {
    fs::remove_all(place_);
    fs::create_directory(place_);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(place_, ignored);
  }
  fs::path operator/(const char* name) const { return place_ / name; }
  std::ptrdiff_t count() const {
    return std::distance(fs::directory_iterator(place_), fs::directory_iterator());
  }

 private:
  fs::path place_;
};

std::string content_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("A file has its name when it is finished, and is as it was until then") {
  const Scratch folder;
  std::ofstream(folder / "path.csv") << "before";
  {
    OutputFile file(folder / "path.csv");
    file.write("after");
    CHECK(content_of(folder / "path.csv") == "before");
    file.finish();
    CHECK(content_of(folder / "path.csv") == "after");
  }
  CHECK(content_of(folder / "path.csv") == "after");
  CHECK(folder.count() == 1);
  { OutputFile(folder / "path.csv").write("never finished"); }
  CHECK(content_of(folder / "path.csv") == "after");
  CHECK(folder.count() == 1);
}

TEST_CASE("A file that can't get its name in the end says so, and leaves nothing behind") {
  const Scratch folder;
  {
    OutputFile file(folder / "path.csv");
    file.write("all of it");
    fs::create_directory(folder / "path.csv");  // meanwhile, by somebody else
    CHECK_THROWS_WITH_AS(file.finish(), doctest::Contains("path.csv"), FileError);
  }
  CHECK(fs::is_directory(folder / "path.csv"));
  CHECK(folder.count() == 1);
}

TEST_CASE("A link stays a link, and where it leads the file is written") {
  const Scratch folder;
  std::ofstream(folder / "path.csv") << "before";
  fs::create_symlink("path.csv", folder / "link.csv");
  OutputFile file(folder / "link.csv");
  file.write("after");
  file.finish();
  CHECK(fs::is_symlink(folder / "link.csv"));
  CHECK(content_of(folder / "path.csv") == "after");
}
