// Random tops of all sizes and speeds, with random torques: who stays finite, and do the books
// close?
#include <support/items.hpp>
#include <support/random_tops.hpp>
#include <support/record.hpp>
#include <support/rungs.hpp>
#include <tumble/guarded_turn.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

const int steps = 1000;

/// The fastest spin, so that no turn of any rung exceeds the limit: |L| may double, and of the
/// portions of a row the largest is 2.4 steps.
template <class Real>
const double fastest = SineCosineConstants<Real>::limit / 2.0 / 2.4 * 60 / 2;

/// How many tops; a rung of high order gets a part of them, for the time that it takes.
int wanted_count() {
  return std::getenv("TUMBLE_FULL") != nullptr ? 1'000'000 : 20'000;
}

/// The worst that is left in the books of `count` tops, as many at a time as are in a `Number`: a
/// number of its own, or a pack.
template <class Real, class Number, class Turn>
Unexplained<double> worst_of(const Turn& turn, int count) {
  constexpr int width = std::is_same_v<Number, Real> ? 1 : natural_width<Real>;
  RandomGenerator dice(14);
  Unexplained<double> worst{0, 0};
  std::array<Top<Real>, width> tops;
  std::array<Unexplained<Real>, width> left;
  for (int done = 0; done < count; done += width) {
    for (Top<Real>& top : tops) top = random_top<Real>(dice, fastest<Real>, steps / 60.0);
    if constexpr (width == 1) {
      left[0] = booked<Real>(tops[0], turn, Real(1) / 60, steps);
    } else {
      Top<Number> pack;
      for (int lane = 0; lane < width; ++lane) set_lane(pack, lane, tops[std::size_t(lane)]);
      const Unexplained<Number> of_pack = booked<Number>(pack, turn, Real(1) / 60, steps);
      for (int lane = 0; lane < width; ++lane) {
        tops[std::size_t(lane)] = lane_of(pack, lane);
        left[std::size_t(lane)] = {of_pack.momentum[lane], of_pack.energy[lane]};
      }
    }
    for (std::size_t n = 0; n < width; ++n) {
      expect(is_finite(tops[n].angular_momentum_body), "every top stays finite");
      expect(std::abs(norm(tops[n].orientation) - 1) < 1e-5, "every orientation stays unit");
      worst.momentum = std::max(worst.momentum, double(left[n].momentum));
      worst.energy = std::max(worst.energy, double(left[n].energy));
    }
  }
  return worst;
}

/// What the books may leave: a step makes at most 111 turns, of three roundings each, and some 60
/// more in the kick and in the books.
template <class Real>
const double rounding = steps * 400 * std::numeric_limits<Real>::epsilon() / 2;

/// The rungs that claim to stay finite, on random tops: they must, and their books must close. One
/// item a rung.
template <class Real>
class Trial {
 public:
  Trial(Items& items, const char* precision) : items_(items), precision_(precision) {}

  template <class Number, class Turn>
  void add(std::string_view name, int count, const Turn& turn) {
    items_.add(item(name), [=] {
      const Unexplained<double> worst = worst_of<Real, Number>(turn, count);
      return number(worst.momentum) + '\t' + number(worst.energy);
    });
    tried_.push_back({name, count});
  }

  /// Those that have not been added yet, one top at a time.
  void add_others(int count) {
    for (const TurningRung<Real>& rung : rungs<Real>())
      if (rung.claims.bounded &&
          std::none_of(tried_.begin(), tried_.end(),
                       [&](const Tried& tried) { return tried.name == rung.name; }))
        add<Real>(rung.name, count, rung.turn);
  }

  void report(const Notebook& notebook) const {
    Table table = notebook.table("random_in_" + precision_,
                                 {"rung", "tops", "L unexplained", "energy unexplained"});
    std::printf("in %-27s %8s  unexplained: L   energy\n", precision_.c_str(), "tops");
    for (const auto& [name, count] : tried_) {
      const Claims claims = rung_called<Real>(name).claims;
      expect(claims.bounded, "only those that claim to stay finite are tried here");
      const auto cells = cells_of(items_.result(item(name))).at(0);
      const double momentum = std::stod(cells.at(0)), energy = std::stod(cells.at(1));
      expect(energy <= rounding<Real>, "the books of the energy close");
      expect(!claims.momentum || momentum <= rounding<Real>, "those of L close where it is kept");
      expect(claims.momentum || momentum > 0.1, "and where it is not, they don't");
      std::printf("%-30s %8d      %7.1e  %7.1e\n", std::string(name).c_str(), count, momentum,
                  energy);
      table.row(name, std::to_string(count), number("%.0e", momentum), number("%.0e", energy));
    }
  }

 private:
  struct Tried {
    std::string_view name;
    int count;
  };

  std::string item(std::string_view name) const { return std::string(name) + " in " + precision_; }

  Items& items_;
  std::string precision_;
  std::vector<Tried> tried_;
};

/// Chapter 8's rules in packs, the others on a hundredth of as many tops.
template <class Real>
Trial<Real> bounded(Items& items, const char* precision) {
  const int many = wanted_count();
  using Packed = Pack<Real, natural_width<Real>>;
  Trial<Real> trial(items, precision);
  const auto in_packs = [&](const char* name, const auto& turn) {
    trial.template add<Packed>(name, many, turn);
  };
  in_packs("steady", [](auto& top, auto h) { turn_steadily(top, h); });
  in_packs("explicit, |L| restored", [](auto& top, auto h) { turn_restoring_momentum(top, h); });
  in_packs("linearly implicit", [](auto& top, auto h) { turn_linearly_implicitly(top, h); });
  in_packs("momentum-carrying", [](auto& top, auto h) { turn_carrying_momentum(top, h); });
  in_packs("splitting by axes", [](auto& top, auto h) { turn_axis_by_axis(top, h); });
  in_packs("splitting", [](auto& top, auto h) { turn_by_splitting(top, h); });
  trial.add_others(many / 100);
  return trial;
}

/// A rung that claims no bound, with the guard: how many tops are stopped, and what the last one
/// says. None goes on with what is no number.
template <class Real>
std::string stopped(const TurningRung<Real>& rung, int count) {
  RandomGenerator dice(14);
  int stopped = 0;
  std::string sentence;
  for (int n = 0; n < count; ++n) {
    Top<Real> top = random_top<Real>(dice, fastest<Real>, steps / 60.0);
    try {
      for (int step = 0; step < steps; ++step) {
        kick(top, Real(1) / 60);
        turn_or_stop(rung, top, Real(1) / 60);
      }
    } catch (const TurnError& error) {
      ++stopped;
      sentence = error.what();
    }
    expect(is_finite(top.angular_momentum_body), "nobody goes on with what is no number");
  }
  return std::to_string(stopped) + '\t' + sentence;
}

template <class Real>
void add_unbounded(Items& items, const std::string& precision, int count) {
  for (const TurningRung<Real>& rung : rungs<Real>())
    if (!rung.claims.bounded)
      items.add("guarded " + std::string(rung.name) + " in " + precision,
                [=] { return stopped(rung, count); });
}

template <class Real>
void report_unbounded(const Items& items, const std::string& precision, int count) {
  std::printf("\nguarded, in %-18s %8s  stopped\n", precision.c_str(), "tops");
  for (const TurningRung<Real>& rung : rungs<Real>()) {
    if (rung.claims.bounded) continue;
    const std::string name(rung.name);
    auto cells = cells_of(items.result("guarded " + name + " in " + precision)).at(0);
    cells.resize(2);  // who stops nobody says nothing
    expect(cells[0] == "0" || cells[1].find("'" + name + "' ") == 0, "who stops says its name");
    std::printf("%-30s %8d  %7s\n", name.c_str(), count, cells[0].c_str());
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  Items items;
  const auto in_double = bounded<double>(items, "double");
  const auto in_float = bounded<float>(items, "float");
  const int few = wanted_count() / 100;
  add_unbounded<double>(items, "double", few);
  add_unbounded<float>(items, "float", few);
  if (!items.are_wanted()) return 0;

  Notebook notebook(argument_count, arguments);
  in_double.report(notebook);
  std::printf("\n");
  in_float.report(notebook);
  report_unbounded<double>(items, "double", few);
  report_unbounded<float>(items, "float", few);
  notebook.value("tops", std::to_string(wanted_count()));
  notebook.value("steps", std::to_string(steps));
}
