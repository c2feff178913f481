// Prints every key that the loader knows: object, key, unit, and whether it is required; then every
// turning method, and every scheme after the word "scheme".
#include <cstdio>
#include <string>
#include <support/scene_rules.hpp>
#include <tumble/scene/keys.hpp>
#include <tumble/scene/scene.hpp>

template <class Kinds>
void print(const Kinds& kinds) {
  for (const auto& kind : kinds)
    for (const auto& key : kind.keys)
      std::printf("%s\t%s\t%s\t%s\n", std::string(kind.name).c_str(), std::string(key.name).c_str(),
                  std::string(key.unit).c_str(), key.required ? "required" : "");
}

int main() {
  print(tumble::object_kinds);
  print(tumble::solid_kinds);
  print(tumble::effect_kinds);
  for (const std::string& word : tumble::turning_method_words<tumble::support::SceneRules>())
    std::printf("%s\n", word.c_str());
  for (const std::string& word : tumble::scheme_words()) std::printf("scheme %s\n", word.c_str());
}
