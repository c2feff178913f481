/// @file
/// What is told of the measurements: tables for the terminal and for the book, and numbers for
/// sentences.
#pragma once

#include <support/bench/aims.hpp>
#include <support/bench/table.hpp>

namespace tumble::support::bench {

/// Writes down everything that one run has measured.
class Report {
 public:
  Report(const Measurements& measurements, const Contest& contest, const Extent& extent,
         Notebook& notebook)
      : ratios_(measurements), extent_(extent), notebook_(notebook) {
    prize();
    aims(contest);
    times();
    against("default_rule", "Our world with its own rule, float: how often as long the others take",
            our_world, splitting_loop);
    against("cheapest_rule",
            "Our world with its cheapest stable rule, float: how often as long the others take",
            our_cheapest, cayley_loop);
    memory();
    effects();
    caches();
    values();
  }

 private:
  /// "1,048,576".
  static std::string in_groups(std::size_t count) {
    std::string digits = std::to_string(count);
    for (std::size_t n = digits.size(); n > 3; n -= 3) digits.insert(n - 3, 1, ',');
    return digits;
  }

  using Rows = std::vector<std::vector<std::string>>;

  template <class Row>
  Rows for_each_count(const Row& row) const {
    Rows rows;
    for (const std::size_t count : extent_.counts) {
      rows.push_back({std::to_string(count)});
      for (const Maybe value : row(count)) rows.back().push_back(shown(value));
    }
    return rows;
  }

  /// What packs save, and a second thread.
  void prize() {
    const std::size_t n = extent_.count_of_effects;
    const auto row = [&](const std::string& kept, const std::string& who,
                         int threads) -> std::vector<std::string> {
      return {kept, shown(ratios_.time(who, n, threads)),
              shown(ratios_.time(who, n, threads, "double"))};
    };
    show(notebook_, "prize",
         "ns per body and step of our world, " + std::to_string(n) + " bodies with everything on",
         {{"kept", "kept"}, {"float", "float"}, {"double", "double"}},
         {row("one by one", our_one_by_one, 1), row("in packs", our_world, 1),
          row("in packs, two threads", our_world, 2)});
    for (const std::string precision : {"float", "double"})
      notebook_.value("packs_times_in_" + precision,
                      said(ratio(ratios_.time(our_one_by_one, n, 1, precision),
                                 ratios_.time(our_world, n, 1, precision))));
  }

  void aims(const Contest& contest) const {
    Rows rows;
    for (const Aim& aim : bench::aims(ratios_, extent_.count_of_effects, contest.pace<float>(),
                                      contest.pace<double>()))
      rows.push_back(
          {aim.what, shown(aim.in_float), shown(aim.in_double), "≤ " + number("%g", aim.aim)});
    show(notebook_, "aims", "What is aimed at, and what is reached",
         {{"ratio", "ratio"}, {"float", "float"}, {"double", "double"}, {"aim", "aim"}}, rows);
  }

  void times() const {
    const auto row = [&](std::size_t n) -> std::vector<Maybe> {
      return {ratios_.time(our_world, n),
              ratios_.time(our_cheapest, n),
              ratios_.time(splitting_loop, n),
              ratios_.time(cayley_loop, n),
              ratios_.time(explicit_loop, n),
              ratios_.time(colliding_loop, n),
              ratios_.time(bullet_functions, n),
              ratios_.time(bullet_world, n),
              ratios_.time(ode_world, n, 1, ode_precision)};
    };
    show(notebook_, "times",
         "ns per body and step with everything on; ODE in " + ode_precision +
             ", the others in float",
         {{"bodies", "bodies"},
          {"world", "world"},
          {"cheapest", "world, no sine"},
          {"loop", "loop"},
          {"no sine", "loop, no sine"},
          {"explicit", "loop, explicit"},
          {"2^k apart", "columns 2ᵏ apart"},
          {"Bullet", "Bullet's functions"},
          {"its world", "Bullet's world"},
          {"ODE", "ODE, " + ode_precision}},
         for_each_count(row));
    const auto doubles = [&](std::size_t n) -> std::vector<Maybe> {
      const auto time = [&](const std::string& contender) {
        return ratios_.time(contender, n, 1, "double");
      };
      return {time(our_world),   time(our_cheapest),  time(splitting_loop),
              time(cayley_loop), time(explicit_loop), ratio(time(our_world), time(splitting_loop))};
    };
    show(notebook_, "times_double", "The same in double",
         {{"bodies", "bodies"},
          {"world", "world"},
          {"cheapest", "world, no sine"},
          {"loop", "loop"},
          {"no sine", "loop, no sine"},
          {"explicit", "loop, explicit"},
          {"ratio", "world ÷ loop"}},
         for_each_count(doubles));
  }

  void against(std::string_view name, std::string_view title, const std::string& ours,
               const std::string& loop) const {
    const auto row = [&](std::size_t n) -> std::vector<Maybe> {
      const auto against_us = [&](const std::string& other,
                                  const std::string& precision = "float") {
        return ratio(ratios_.time(other, n, 1, precision), ratios_.time(ours, n));
      };
      return {ratio(ratios_.time(ours, n), ratios_.time(loop, n)),
              against_us(bullet_functions),
              against_us(without_gyroscopic(bullet_functions)),
              against_us(bullet_world),
              against_us(ode_world, ode_precision),
              against_us(without_gyroscopic(ode_world), ode_precision),
              ratio(ratios_.time(ours, n), ratios_.time(ours, n, 2)),
              ratio(ratios_.time(loop, n), ratios_.time(loop, n, 2))};
    };
    show(notebook_, name, title,
         {{"bodies", "bodies"},
          {"us/loop", "world ÷ loop"},
          {"Bullet/us", "Bullet's functions ÷ world"},
          {"off", "term off"},
          {"world/us", "Bullet's world ÷ ours"},
          {"ODE/us", "ODE ÷ world"},
          {"off", "term off"},
          {"we, 1/2", "world, two threads"},
          {"loop, 1/2", "loop, two threads"}},
         for_each_count(row));
  }

  void memory() const {
    using Ours = OurWorld<float>;
    const auto row = [&](std::size_t n) -> std::vector<Maybe> {
      const auto percent = [&](double bytes, const std::string& who, Scene scene) -> Maybe {
        const Maybe share = ratios_.share_of_bandwidth(bytes, ratios_.time(who, scene, n), n);
        return share ? Maybe(100 * *share) : share;
      };
      constexpr Scene all = Scene::everything, points = Scene::points_under_gravity;
      return {static_cast<double>(bytes_of_bodies(n)) / 1024,
              ratios_.bandwidth(n),
              ratios_.bandwidth(n, 2),
              percent(Ours::bytes_of_step(all), our_world, all),
              percent(Ours::bytes_of_step(all), our_cheapest, all),
              percent(bytes_of_step<float>(all), splitting_loop, all),
              percent(bytes_of_step<float>(all), cayley_loop, all),
              percent(bytes_of_step<float>(all), explicit_loop, all),
              percent(Ours::bytes_of_step(points), our_world, points)};
    };
    show(notebook_, "bandwidth",
         "What the memory can do, and the part of it that is used, %; the last column: points "
         "under gravity",
         {{"bodies", "bodies"},
          {"KiB", "KiB"},
          {"GB/s", "GB/s"},
          {"2 threads", "GB/s, two threads"},
          {"world", "world (%)"},
          {"cheapest", "no sine (%)"},
          {"loop", "loop (%)"},
          {"no sine", "loop, no sine (%)"},
          {"explicit", "loop, explicit (%)"},
          {"points", "world, points (%)"}},
         for_each_count(row));
  }

  void effects() const {
    Rows rows;
    for (std::size_t i = 0; i < scene_names.size(); ++i) {
      const auto time = [&](const std::string& who, const std::string& precision) {
        return ratios_.time(who, static_cast<Scene>(i), extent_.count_of_effects, precision);
      };
      rows.push_back({std::string(scene_names[i])});
      for (const std::string& precision : {std::string("float"), std::string("double")}) {
        const Maybe ours = time(our_world, precision), loop = time(splitting_loop, precision);
        rows.back().insert(rows.back().end(), {shown(ours), shown(loop), shown(ratio(ours, loop))});
      }
    }
    show(notebook_, "effects",
         "ns per body and step of scenes with one effect more or another, " +
             std::to_string(extent_.count_of_effects) + " bodies",
         {{"scene", "scene"},
          {"float", "world, float"},
          {"loop", "loop, float"},
          {"ratio", "ratio, float"},
          {"double", "world, double"},
          {"loop", "loop, double"},
          {"ratio", "ratio, double"}},
         rows);
  }

  /// Where the levels of the memory end, as a number of bodies.
  void caches() const {
    Table table = notebook_.table("caches", {"level", "KiB", "bodies"});
    for (const auto& cache : benchmark::CPUInfo::Get().caches)
      if (cache.type != "Instruction")
        table.row(cache.level, cache.size / 1024.,
                  static_cast<double>(cache.size) / static_cast<double>(bytes_of_bodies(1)));
  }

  /// For the prose: in the cache, and out of it as far as it was measured.
  void values() {
    const std::size_t in = extent_.count_of_effects, out = extent_.counts.back();
    const auto note = [&](const std::string& name, Maybe value) {
      notebook_.value(name, said(value));
    };
    const auto at = [&](const std::string& who, std::size_t n) { return ratios_.time(who, n); };
    const auto peers = [&]() -> std::string {
      const bool has_bullet = at(bullet_functions, in).has_value();
      const bool has_ode = ratios_.time(ode_world, in, 1, ode_precision).has_value();
      return has_bullet && has_ode ? "Bullet and ODE"
             : has_bullet          ? "Bullet"
             : has_ode             ? "ODE"
                                   : "";
    };
    notebook_.value("peers", peers());
    notebook_.value("most_of_peers", in_groups(extent_.most_of_peers));
#ifdef TUMBLE_OWN_PEERS
    notebook_.value("peers_compiled", "from its own sources, with the same flags");
#else
    notebook_.value(
        "peers_compiled",
        "by the distribution, which on Debian means for every processor of the architecture");
#endif
    notebook_.value("bodies_in_cache", in_groups(in));
    notebook_.value("bodies_out_of_cache", in_groups(out));
    for (const auto& [rule, ours, loop] : {std::tuple{"default", our_world, splitting_loop},
                                           {"cheapest", our_cheapest, cayley_loop}}) {
      const std::string name = std::string(rule) + "_";
      note(name + "ns", at(ours, in));
      note(name + "loop_ns", at(loop, in));
      note(name + "over_loop", ratio(at(ours, in), at(loop, in)));
      note(name + "over_loop_out_of_cache", ratio(at(ours, out), at(loop, out)));
      note(name + "bullet_functions", ratio(at(bullet_functions, in), at(ours, in)));
      note(name + "bullet_world", ratio(at(bullet_world, in), at(ours, in)));
      note(name + "ode", ratio(ratios_.time(ode_world, in, 1, ode_precision), at(ours, in)));
      note(name + "two_threads", ratio(at(ours, in), ratios_.time(ours, in, 2)));
      const Maybe share = ratios_.share_of_bandwidth(
          OurWorld<float>::bytes_of_step(Scene::everything), at(ours, out), out);
      note(name + "percent_of_bandwidth", share ? Maybe(100 * *share) : share);
    }
    note("explicit_loop_ns", at(explicit_loop, in));
    note("explicit_loop_out_of_cache_ns", at(explicit_loop, out));
    Maybe trap;
    for (const std::size_t n : extent_.counts)
      if (const Maybe times = ratio(at(colliding_loop, n), at(explicit_loop, n)); times > trap)
        trap = times;
    note("power_of_two_trap", trap);
    note("bandwidth", ratios_.bandwidth(out));
    note("bandwidth_two_threads", ratios_.bandwidth(out, 2));
    constexpr Scene points = Scene::points_under_gravity;
    note("points_over_bandwidth",
         ratio(1, ratios_.share_of_bandwidth(OurWorld<float>::bytes_of_step(points),
                                             ratios_.time(our_world, points, out), out)));
  }

  Ratios ratios_;
  Extent extent_;
  Notebook& notebook_;
};

}  // namespace tumble::support::bench
