#include <functional>
#include <memory>
#include <support/checks.hpp>
#include <tumble/embedded_steps.hpp>
#include <tumble/nystrom_steps.hpp>
#include <vector>

using namespace tumble;
using namespace tumble::support;

namespace {

using Wide = long double;

/// A rooted tree: the trees that hang from its root, in a fixed order. Butcher's condition for it
/// says that a rule gets one term of the exact solution's series right.
struct Tree {
  std::vector<std::shared_ptr<const Tree>> branches;
  int size = 1;
  Wide density = 1;  ///< the product of the sizes of all its subtrees
};
using Shared = std::shared_ptr<const Tree>;

/// All trees of every size up to `largest`: each root with branches that are no larger, in
/// descending order of their number, so that none comes twice.
std::vector<std::vector<Shared>> trees_up_to(int largest) {
  std::vector<std::vector<Shared>> of_size(static_cast<std::size_t>(largest) + 1);
  std::vector<Shared> all;  // in ascending order of size
  for (int size = 1; size <= largest; ++size) {
    std::vector<Shared> branches;
    std::vector<Shared> made;
    const std::function<void(std::size_t, int)> grow = [&](std::size_t below, int left) {
      if (left == 0) {
        Tree tree{branches, size, Wide(size)};
        for (const Shared& branch : branches) tree.density *= branch->density;
        made.push_back(std::make_shared<const Tree>(std::move(tree)));
        return;
      }
      for (std::size_t n = 0; n < below; ++n) {
        if (all[n]->size > left) break;
        branches.push_back(all[n]);
        grow(n + 1, left - all[n]->size);
        branches.pop_back();
      }
    };
    grow(all.size(), size - 1);
    of_size[static_cast<std::size_t>(size)] = made;
    all.insert(all.end(), made.begin(), made.end());
  }
  return of_size;
}

using Weights = std::vector<Wide>;

/// Stages as rows of any length, so that stages beyond the step count too.
struct Stages {
  std::vector<Weights> rows;

  /// For each stage, the product over the branches of what the stages before it make of them.
  Weights weights_of(const Tree& tree) const {
    Weights product(rows.size(), 1);
    for (const Shared& branch : tree.branches) {
      const Weights there = weights_of(*branch);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        Wide sum = 0;
        for (std::size_t j = 0; j < rows[i].size(); ++j) sum += rows[i][j] * there[j];
        product[i] *= sum;
      }
    }
    return product;
  }
};

Wide sum_of(const Weights& weights, const Weights& values) {
  Wide sum = 0;
  for (std::size_t j = 0; j < weights.size(); ++j) sum += weights[j] * values[j];
  return sum;
}

/// The largest miss of a condition over all trees of a size, for weights that lead to `part` of the
/// step.
Wide missed(const Stages& stages, const Weights& weights, const std::vector<Shared>& trees,
            Wide part = 1) {
  Wide worst = 0;
  for (const Shared& tree : trees) {
    const Wide wanted = std::pow(part, Wide(tree->size)) / tree->density;
    worst = std::max(worst, std::abs(sum_of(weights, stages.weights_of(*tree)) - wanted));
  }
  return worst;
}

/// The order that weights show: all conditions up to that size are met to `digits`, and one of the
/// next size is missed by far more.
int order_of(const Stages& stages, const Weights& weights,
             const std::vector<std::vector<Shared>>& trees, Wide part = 1) {
  const Wide digits = 1e-15L;  // coefficients as large as 43 with 30 digits, in 19 digits
  int order = 0;
  while (order + 1 < static_cast<int>(trees.size()) &&
         missed(stages, weights, trees[static_cast<std::size_t>(order) + 1], part) <= digits)
    ++order;
  return order;
}

template <class List>
Weights row_of(const List& list) {
  return Weights(list.begin(), list.end());
}

/// All stages of a pair: those of the step, that at its end, and those beyond.
template <class Pair>
Stages stages_of() {
  Stages stages;
  for (std::size_t i = 0; i < Pair::Rule::rule.nodes.size(); ++i)
    stages.rows.push_back(row_of(Pair::Rule::rule.coefficients[i]));
  stages.rows.push_back(row_of(Pair::Rule::rule.weights));
  for (const auto& row : Pair::more_coefficients) stages.rows.push_back(row_of(row));
  return stages;
}

/// Weights less those of an error: the answer beside.
template <class Pair>
Weights beside(std::size_t error) {
  Weights weights = row_of(Pair::errors[error]);
  for (Wide& weight : weights) weight = -weight;
  for (std::size_t j = 0; j < Pair::Rule::rule.weights.size(); ++j)
    weights[j] += Pair::Rule::rule.weights[j];
  return weights;
}

/// The weights of all stages that make the state at `part` of a step, as within() weighs them.
template <class Pair>
Weights within(Wide part) {
  const std::size_t stages = Pair::Rule::rule.nodes.size();
  const Wide rest = 1 - part;
  Weights weights(stages + 1 + Pair::more_nodes.size(), 0);
  const auto add = [&](Wide factor, const auto& row) {
    for (std::size_t j = 0; j < row.size(); ++j) weights[j] += factor * row[j];
  };
  const Weights step = row_of(Pair::Rule::rule.weights);
  // p (Δ + (1 − p) (k₀ − Δ + p (2Δ − k₀ − k₁ + …)))
  add(part * (1 - rest + 2 * part * rest), step);
  weights[0] += part * rest * (1 - part);
  weights[stages] -= part * part * rest;
  Wide factor = part * rest * part * rest;
  for (std::size_t i = 0; i < Pair::dense.size(); ++i) {
    add(factor, Pair::dense[i]);
    factor *= i % 2 == 0 ? part : rest;
  }
  return weights;
}

}  // namespace

TEST_CASE("There are 1, 1, 2, 4, 9, 20, 48, 115 and 286 rooted trees of one vertex to nine") {
  const auto trees = trees_up_to(9);
  const std::array<std::size_t, 9> counts = {1, 1, 2, 4, 9, 20, 48, 115, 286};
  for (std::size_t size = 1; size <= 9; ++size) CHECK(trees[size].size() == counts[size - 1]);
}

TEST_CASE("The rules of Runge and Kutta meet the condition of every rooted tree of their order") {
  const auto trees = trees_up_to(9);
  const auto order = [&]<class Rule>(Rule) {
    Stages stages;
    for (const auto& row : Rule::rule.coefficients) stages.rows.push_back(row_of(row));
    return order_of(stages, row_of(Rule::rule.weights), trees);
  };
  CHECK(order(Kutta()) == 4);
  CHECK(order(DormandPrinceFifth()) == 5);
  CHECK(order(DormandPrinceEighth()) == 8);
  CHECK(order(FehlbergEighth()) == 8);
}

TEST_CASE("The answers beside an embedded pair have the orders that its name says") {
  const auto trees = trees_up_to(7);
  CHECK(order_of(stages_of<DormandPrince54>(), beside<DormandPrince54>(0), trees) == 4);
  CHECK(order_of(stages_of<DormandPrince853>(), beside<DormandPrince853>(0), trees) == 5);
  CHECK(order_of(stages_of<DormandPrince853>(), beside<DormandPrince853>(1), trees) == 3);
}

TEST_CASE("Within a step the pairs have the fourth and the seventh order, wherever one asks") {
  const auto trees = trees_up_to(8);
  for (const Wide part : {0.1L, 0.3L, 0.5L, 0.75L, 0.9L}) {
    CHECK(order_of(stages_of<DormandPrince54>(), within<DormandPrince54>(part), trees, part) == 4);
    CHECK(order_of(stages_of<DormandPrince853>(), within<DormandPrince853>(part), trees, part) ==
          7);
  }
}

namespace {

/// A tree for x'' = a(x): a vertex is an evaluation of the acceleration, with some branches that
/// are the velocity, and some that are stages before. `place` is what the exact solution makes of
/// it at t: a number times t to the power of its size, which is 2 and 1 for each velocity, and the
/// sizes of the stages.
struct NystromTree {
  int velocities = 0;
  std::vector<std::shared_ptr<const NystromTree>> stages = {};
  int power = 0;  ///< the acceleration is `factor` t^power
  Wide factor = 1;
};
using SharedNystrom = std::shared_ptr<const NystromTree>;

std::vector<SharedNystrom> nystrom_trees_up_to(int largest_power) {
  std::vector<SharedNystrom> all;
  for (int power = 0; power <= largest_power; ++power) {
    std::vector<SharedNystrom> stages, made;
    const std::function<void(std::size_t, int)> grow = [&](std::size_t below, int left) {
      NystromTree tree{left, stages, power, 1};
      for (const SharedNystrom& stage : stages)
        tree.factor *= stage->factor / ((stage->power + 1) * (stage->power + 2));
      made.push_back(std::make_shared<const NystromTree>(std::move(tree)));
      for (std::size_t n = 0; n < below && all[n]->power + 2 <= left; ++n) {
        stages.push_back(all[n]);
        grow(n + 1, left - all[n]->power - 2);
        stages.pop_back();
      }
    };
    grow(all.size(), power);
    all.insert(all.end(), made.begin(), made.end());
  }
  return all;
}

template <class Rule>
Weights weights_of(const NystromTree& tree) {
  Weights product;
  for (const Wide node : Rule::nodes) product.push_back(std::pow(node, Wide(tree.velocities)));
  for (const SharedNystrom& stage : tree.stages) {
    const Weights there = weights_of<Rule>(*stage);
    for (std::size_t i = 0; i < product.size(); ++i)
      product[i] *= sum_of(row_of(Rule::stages[i]), there);
  }
  return product;
}

struct Rule86 {
  static constexpr auto& nodes = DormandPrinceNystrom86::rule.nodes;
  static constexpr auto& stages = DormandPrinceNystrom86::rule.coefficients;
};

}  // namespace

TEST_CASE("The Nystrom pair meets all conditions of eighth and, beside, of sixth order") {
  const auto& rule = DormandPrinceNystrom86::rule;
  // By how much the weights of places and of velocities miss, for accelerations as t^power: errors
  // of the order power + 2 in places and power + 1 in velocities.
  std::array<Wide, 10> places = {}, velocities = {}, places_beside = {}, velocities_beside = {};
  for (const SharedNystrom& tree : nystrom_trees_up_to(8)) {
    const Weights values = weights_of<Rule86>(*tree);
    const auto power = static_cast<std::size_t>(tree->power);
    const Wide velocity = tree->factor / (tree->power + 1), place = velocity / (tree->power + 2);
    const auto miss = [&](Wide& worst, const Weights& weights, Wide wanted) {
      worst = std::max(worst, std::abs(sum_of(weights, values) - wanted));
    };
    miss(places[power], row_of(rule.places), place);
    miss(velocities[power], row_of(rule.velocities), velocity);
    Weights beside_places = row_of(rule.places), beside_velocities = row_of(rule.velocities);
    for (std::size_t j = 0; j < values.size(); ++j) {
      beside_places[j] -= rule.errors_of_places[j];
      beside_velocities[j] -= rule.errors_of_velocities[j];
    }
    miss(places_beside[power], beside_places, place);
    miss(velocities_beside[power], beside_velocities, velocity);
  }
  const Wide digits = 1e-17L;  // nine products of numbers under 10
  for (std::size_t power = 0; power <= 7; ++power) {
    if (power <= 6) CHECK(places[power] <= digits);
    CHECK(velocities[power] <= digits);
    if (power <= 4) CHECK(places_beside[power] <= digits);
    if (power <= 5) CHECK(velocities_beside[power] <= digits);
  }
  CHECK(velocities[8] > 1e-9L);
  CHECK(velocities_beside[6] > 1e-9L);
}
