#include "page_text.hpp"

#include <support/checks.hpp>

using namespace tumble::simulate;

TEST_CASE("The engine's bytes stand in a page as RFC 4648 writes them") {
  for (const auto& [bytes, text] : {std::pair("", ""),
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"},
                                    {"\xff\xef\xbe", "/+++"}})
    CHECK(base64(bytes) == text);
}

TEST_CASE("What a title says stands in a page as it is") {
  CHECK(escaped("a < b & c > d, &lt;") == "a &lt; b &amp; c &gt; d, &amp;lt;");
}

TEST_CASE("A page says what its scene is called, and holds its file and the engine") {
  const struct { std::string title = "A < B", description = "C & D"; } scene;
  std::string page =
      live_page(scene, "{\"title\": \"</script>\"}\n", "a \"b\".json", "draw();\n", "foob");
  using namespace tumble::support;
  for (const auto& [name, part] : {std::pair("player style", player_style),
                                   {"live style", live_style},
                                   {"player script", player_script},
                                   {"live script", live_script}}) {
    const std::size_t begin = page.find(part);
    REQUIRE(begin != std::string::npos);
    page.replace(begin, part.size(), std::string(name) + "\n");
  }
  CHECK(page == R"(<!DOCTYPE html>
<html lang="en-GB">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>A &lt; B</title>
<link rel="icon" href="data:,">
<style>
player style
live style
</style>
</head>
<body class="player-page">
<main>
<h1>A &lt; B</h1>
<p>C &amp; D</p>
<noscript><p>The scene is computed and drawn by a script, and this browser runs none.</p></noscript>
<figure class="live" id="live_scene" data-live="scene" data-script="">
<div class="live-picture"></div>
<script type="application/json" class="live-texts">{"scene":"{\"title\": \"\u003c/script>\"}\u000a","file":"a \"b\".json"}</script>
</figure>
</main>
<script>
player script
live script
draw();
tumble_live.modules.scene = 'Zm9vYg==';
</script>
</body>
</html>
)");
}
