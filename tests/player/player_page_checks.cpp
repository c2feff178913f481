#include <support/checks.hpp>
#include <support/player_page.hpp>

using namespace tumble::support;

namespace {

std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder that is there while this is.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "tumble_player_page_checks";
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }

  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(path), {});
  }
};

}  // namespace

TEST_CASE("The page holds the player, its style and the recording, and nothing unfinished stays") {
  const Folder folder;
  write_player_page(folder.path / "replay.html", R"({"title":"A page"})");
  const std::string page = text_of_file(folder.path / "replay.html");
  CHECK(page == player_page(R"({"title":"A page"})"));
  CHECK(page.find(player_script) != std::string::npos);
  CHECK(page.find(player_style) != std::string::npos);
  CHECK(page.find(R"({"title":"A page"})") != std::string::npos);
  CHECK(folder.files() == 1);
}

TEST_CASE("A name that holds </script> does not end the script") {
  const std::string page = player_page(R"({"title":"</script><!--"})");
  CHECK(page.find(R"("\u003c/script>\u003c!--")") != std::string::npos);
}

TEST_CASE("Neither the script nor the style ends its own element") {
  CHECK(player_script.find("</script") == std::string_view::npos);
  CHECK(player_script.find("<!--") == std::string_view::npos);
  CHECK(player_style.find("</style") == std::string_view::npos);
}

TEST_CASE("A page that can't be written is refused, and what was there stays") {
  const Folder folder;
  CHECK_THROWS_AS(write_player_page(folder.path / "absent" / "replay.html", "{}"),
                  std::runtime_error);
  // A folder that is not empty stands where the page should go.
  std::filesystem::create_directories(folder.path / "replay.html" / "inner");
  CHECK_THROWS_AS(write_player_page(folder.path / "replay.html", "{}"), std::runtime_error);
  CHECK(std::filesystem::exists(folder.path / "replay.html" / "inner"));
  CHECK(folder.files() == 1);
}
