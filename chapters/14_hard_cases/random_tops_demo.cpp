// Random tops of all sizes and speeds, with random torques: who stays finite, and do the books
// close?
#include <course/random_tops.hpp>
#include <course/record.hpp>
#include <course/rungs.hpp>
#include <tumble/guarded_turn.hpp>

using namespace tumble;
using namespace tumble::course;

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
  Dice dice(14);
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

/// The rungs that claim to stay finite, on random tops: they must, and their books must close.
template <class Real>
class Trial {
 public:
  Trial(const Notebook& notebook, const char* precision)
      : table_(notebook.table("random_in_" + std::string(precision),
                              {"rung", "tops", "L unexplained", "energy unexplained"})) {
    std::printf("in %-27s %8s  unexplained: L   energy\n", precision, "tops");
  }

  template <class Number, class Turn>
  void run(std::string_view name, int count, const Turn& turn) {
    const Claims claims = rung_called<Real>(name).claims;
    expect(claims.bounded, "only those that claim to stay finite are tried here");
    const Unexplained<double> worst = worst_of<Real, Number>(turn, count);
    expect(worst.energy <= rounding<Real>, "the books of the energy close");
    expect(!claims.momentum || worst.momentum <= rounding<Real>,
           "those of L close where it is kept");
    expect(claims.momentum || worst.momentum > 0.1, "and where it is not, they don't");
    std::printf("%-30s %8d      %7.1e  %7.1e\n", std::string(name).c_str(), count, worst.momentum,
                worst.energy);
    table_.row(name, std::to_string(count), number("%.0e", worst.momentum),
               number("%.0e", worst.energy));
    tried_.push_back(name);
  }

  /// Those that have not been tried yet, one top at a time.
  void run_others(int count) {
    for (const TurningRung<Real>& rung : rungs<Real>())
      if (rung.claims.bounded && std::find(tried_.begin(), tried_.end(), rung.name) == tried_.end())
        run<Real>(rung.name, count, rung.turn);
  }

 private:
  Table table_;
  std::vector<std::string_view> tried_;
};

/// Chapter 8's rules in packs, the others on a hundredth of as many tops.
template <class Real>
void try_bounded(const Notebook& notebook, const char* precision) {
  const int many = wanted_count();
  using Packed = Pack<Real, natural_width<Real>>;
  Trial<Real> trial(notebook, precision);
  const auto in_packs = [&](const char* name, const auto& turn) {
    trial.template run<Packed>(name, many, turn);
  };
  in_packs("steady", [](auto& top, auto h) { turn_steadily(top, h); });
  in_packs("explicit, |L| restored", [](auto& top, auto h) { turn_restoring_momentum(top, h); });
  in_packs("linearly implicit", [](auto& top, auto h) { turn_linearly_implicitly(top, h); });
  in_packs("momentum-carrying", [](auto& top, auto h) { turn_carrying_momentum(top, h); });
  in_packs("splitting by axes", [](auto& top, auto h) { turn_axis_by_axis(top, h); });
  in_packs("splitting", [](auto& top, auto h) { turn_by_splitting(top, h); });
  trial.run_others(many / 100);
}

/// The rungs that claim no bound, with the guard: some tops are stopped, with a sentence, and none
/// goes on with what is no number.
//! [stopped]
template <class Real>
void try_unbounded(Table& table, const char* precision, int count) {
  std::printf("\nguarded, in %-18s %8s  stopped\n", precision, "tops");
  for (const TurningRung<Real>& rung : rungs<Real>()) {
    if (rung.claims.bounded) continue;
    Dice dice(14);
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
    expect(stopped == 0 || sentence.find("'" + std::string(rung.name) + "' ") == 0,
           "who stops says its name");
    table.row(rung.name, precision, std::to_string(count), std::to_string(stopped), sentence);
    std::printf("%-30s %8d  %7d\n", std::string(rung.name).c_str(), count, stopped);
  }
}
//! [stopped]

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  try_bounded<double>(notebook, "double");
  std::printf("\n");
  try_bounded<float>(notebook, "float");
  Table table =
      notebook.table("stopped", {"rung", "precision", "tops", "stopped", "the last says"});
  try_unbounded<double>(table, "double", wanted_count() / 100);
  try_unbounded<float>(table, "float", wanted_count() / 100);
  notebook.value("tops", std::to_string(wanted_count()));
  notebook.value("few_tops", std::to_string(wanted_count() / 100));
  notebook.value("steps", std::to_string(steps));
  notebook.value("rounding_double", number("%.0e", rounding<double>));
  notebook.value("rounding_float", number("%.0e", rounding<float>));
}
