// print_refusals [FILE...]: texts of scenes, and the sentence that the reader has for each, as a
// list of JSON. The texts are those of bad_scenes() and of the files. What is no UTF-8 is left out,
// since no page can have such a text; what is refused for no reason of the reader's has none.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <support/bad_scenes.hpp>
#include <support/scene_rules.hpp>
#include <tumble/scene/read_scene.hpp>

namespace {

using nlohmann::json;

json refusal_of(const std::string& text) {
  try {
    tumble::read_scene<double, tumble::OneByOne<double>, tumble::support::SceneRules>(text,
                                                                                      "bad.json");
    return nullptr;
  } catch (const tumble::SceneError& error) {
    return error.what();
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  std::vector<std::string> texts;
  for (const auto& scene : tumble::support::bad_scenes()) texts.push_back(scene.text);
  for (int n = 1; n < argument_count; ++n) {
    std::ifstream in(arguments[n], std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  json list = json::array();
  for (const std::string& text : texts) {
    const json pair = {{"text", text}, {"refusal", refusal_of(text)}};
    try {
      (void)pair.dump();
      list.push_back(pair);
    } catch (const json::type_error&) {  // no UTF-8
    }
  }
  std::puts(list.dump().c_str());
}
