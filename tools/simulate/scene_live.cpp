// A scene to edit, live: its text becomes a world, which says its plan and is run to its end, with
// its books. simulate --live writes a page with the same module.
#define JSON_HAS_FILESYSTEM 0  // WASI's C++ library has no files, and no text of ours is one
#define JSON_HAS_EXPERIMENTAL_FILESYSTEM 0
#include <first_scene.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <support/live.hpp>
#include <tumble/scene/keys.hpp>

#include "books.hpp"
#include "live_run.hpp"

using namespace tumble;

namespace {

std::optional<simulate::LiveRun> kept;  // from one part of the work to the next

using nlohmann::json;

/// The units of all keys, by the kind of object that has them.
std::string units_of_keys() {
  json units;
  const auto add = [&](const auto& kinds) {
    for (const ObjectKeys& kind : kinds)
      for (const Key& key : kind.keys)
        if (!key.unit.empty()) units[std::string(kind.name)][std::string(key.name)] = key.unit;
  };
  add(object_kinds);
  add(solid_kinds);
  add(effect_kinds);
  return units.dump();
}

std::string json_of(const Plan& plan) {
  json rows = json::array();
  for (const PlanRow& row : plan.rows)
    rows.push_back({{"effect", row.effect},
                    {"phase", name_of(row.phase)},
                    {"visited", row.visited},
                    {"of", row.of},
                    {"reason", row.reason}});
  return json{{"rows", rows},
              {"accuracy", text_of(plan.accuracy)},
              {"warnings", plan.warnings},
              {"unknown", plan.unknown}}
      .dump();
}

std::string drawn() {
  support::Recording recording(kept->scene().title,
                               kept->time_step() * static_cast<double>(kept->every()));
  simulate::draw(kept->scene(), recording);
  return recording.json();
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const std::string text = live.text("scene", simulate::first_scene),
                    file = live.text("file", "scene.json");
  if (!kept || !kept->is_of(text, file)) {
    kept.reset();
    kept.emplace(text, file);
  }
  if (!kept->is_complete()) kept->go_on();
  if (!kept->is_complete()) {
    live.say("progress", text_of(100 * kept->scene().world.ticks() / kept->steps()));
    return live.go_on();
  }
  const simulate::LiveRun::Frames& frames = kept->frames();
  live.column("time", "s") = frames.times;
  live.column("poses", "") = frames.poses;
  live.column("kinetic", "J") = frames.kinetic;
  live.column("stored", "J") = frames.stored;
  std::vector<double>& last = live.column("last", "");
  simulate::for_each_body(kept->scene(), [&](const std::string&, const auto& body) {
    for (const double number : simulate::state_of(body)) last.push_back(number);
  });
  live.say("recording", drawn());
  live.say("plan", json_of(kept->plan()));
  live.say("books", simulate::books_of(kept->ledger(), kept->scene()));
  live.say("units", units_of_keys());
  live.say("methods", json(turning_method_words<SceneRules>()).dump());
  live.say("schemes", json(scheme_words()).dump());
}

#ifdef __wasm__
extern "C" {
/// How many parts a step of the scene has that was run last; none after a refusal.
[[clang::export_name("scene_parts")]] int scene_parts() {
  return kept ? kept->part_count() : 0;
}
/// See LiveRun::run_part(); the page holds the clock.
[[clang::export_name("scene_run_part")]] void scene_run_part(int part, int rounds, int steps) {
  if (kept && part < kept->part_count()) kept->run_part(part, rounds, steps);
}
}  // extern "C"
#endif
