/// @file
/// Whether a student's function is one and no table of answers: it and the reference, which is the
/// course's solution, are asked about something that nobody could know.
#pragma once

#include <algorithm>
#include <exercise/wire.hpp>
#include <functional>
#include <map>
#include <random>
#include <span>

namespace tumble::exercise {

/// A question as it is sent, and what must be known of its numbers to vary it.
struct Question {
  std::string line;
  std::vector<std::size_t> begins;       ///< of each argument, counted in numbers
  std::vector<std::size_t> quaternions;  ///< where four numbers begin that have norm 1
};

/// Goes through a value as `put` does, and notes where its quaternions begin.
template <class Value>
void find_quaternions(const Value& value, std::size_t& at, std::vector<std::size_t>& found) {
  if constexpr (requires { value.imaginary; }) found.push_back(at);
  if constexpr (std::is_arithmetic_v<Value>) {
    ++at;
  } else if constexpr (requires { fields(value); }) {
    std::apply([&](const auto&... field) { (find_quaternions(field, at, found), ...); },
               fields(value));
  } else if constexpr (requires { value.push_back(value[0]); }) {
    ++at;
    for (const auto& item : value) find_quaternions(item, at, found);
  } else {
    at += static_cast<std::size_t>(value.size());
  }
}

template <class... Arguments>
Question question(const char* function, const Arguments&... arguments) {
  Question asked{function, {}, {}};
  std::size_t at = 0;
  [[maybe_unused]] const auto add = [&](const auto& argument) {  // of none there is nothing to add
    asked.begins.push_back(at);
    put(asked.line, argument);
    find_quaternions(argument, at, asked.quaternions);
  };
  (add(arguments), ...);
  return asked;
}

/// What the documentation of a function asks of one of its arguments, counted from 0. Beside the
/// checks it is declared as `const Precondition direction("felt_mass", 2, of_length_one);`, and
/// questions that are varied are made to meet it. Quaternions keep their norm 1 without, and
/// numbers that are equal stay equal: so a tensor stays symmetric, and so does a top.
struct Precondition {
  using Meet = void (*)(std::span<double> numbers);
  Precondition(const char* function_, std::size_t argument_, Meet meet_)
      : function(function_), argument(argument_), meet(meet_) {
    declared().push_back(*this);
  }
  /// A count, which may be varied only so: to another one from `least` to `most`.
  Precondition(const char* function_, std::size_t argument_, int least_, int most_)
      : function(function_), argument(argument_), least(least_), most(most_) {
    declared().push_back(*this);
  }
  static std::vector<Precondition>& declared() {
    static std::vector<Precondition> all;
    return all;
  }

  std::string function;
  std::size_t argument;
  Meet meet = nullptr;
  int least = 0, most = -1;
};

inline void of_length_one(std::span<double> numbers) {
  double square = 0;
  for (const double number : numbers) square += number * number;
  for (double& number : numbers) number /= std::sqrt(square);
}
inline void whole(std::span<double> numbers) {
  for (double& number : numbers) number = std::round(number);
}
inline void at_most_one(std::span<double> numbers) {
  for (double& number : numbers) number = std::min(number, 1.0);
}
inline void powers_of_two(std::span<double> numbers) {
  for (double& number : numbers) number = std::exp2(std::round(std::log2(number)));
}

/// Varies questions by chance. What it draws is the same in every run with the same seed.
class Varied {
 public:
  explicit Varied(std::uint64_t seed) : chance_(seed) {}

  /// A number below `end`.
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(chance_() % end); }

  /// The question with one of its numbers larger or smaller by `part` to twice that, and all that
  /// are equal to it; a count becomes another one. The question itself if it can't vary.
  Question in(const Question& asked, std::size_t which, double part) {
    Numbers numbers(asked);
    const double old = numbers.values[which];
    const double factor = 1 + (below(2) == 0 ? part : -part) * (1 + double(below(1024)) / 1024);
    if (numbers.is_quantity[which])
      for (std::size_t i = 0; i < numbers.values.size(); ++i)
        if (numbers.is_quantity[i] && std::abs(numbers.values[i]) == std::abs(old))
          numbers.values[i] *= factor;
    for (const Precondition& each : Precondition::declared())
      if (each.function == numbers.name && each.most > each.least &&
          asked.begins[each.argument] == which)
        numbers.values[which] =
            each.least + double(below(static_cast<std::size_t>(each.most - each.least + 1)));
    return said(asked, numbers);
  }

  /// The question with each of its numbers off by a rounding or two.
  Question rounded(const Question& asked, double rounding) {
    Numbers numbers(asked);
    for (std::size_t i = 0; i < numbers.values.size(); ++i)
      if (numbers.is_quantity[i]) numbers.values[i] *= 1 + (below(2) == 0 ? 2 : -2) * rounding;
    return said(asked, numbers);
  }

  struct Numbers {
    explicit Numbers(const Question& asked) {
      Words words(asked.line);
      name = words.word();
      while (!words.empty()) {
        const std::string_view word = words.word();
        values.push_back(Words(word).number());
        is_quantity.push_back(word.find('x') != word.npos);  // in base 16; counts are in base 10
      }
    }
    std::string name;
    std::vector<double> values;
    std::vector<bool> is_quantity;
  };

 private:
  /// The question with these numbers, once they meet what is asked of them.
  static Question said(const Question& asked, Numbers& numbers) {
    const std::span<double> all(numbers.values);
    for (const std::size_t begin : asked.quaternions) of_length_one(all.subspan(begin, 4));
    for (const Precondition& each : Precondition::declared()) {
      if (each.function != numbers.name || each.meet == nullptr) continue;
      const std::size_t begin = asked.begins[each.argument];
      const bool is_last = each.argument + 1 == asked.begins.size();
      each.meet(
          all.subspan(begin, (is_last ? all.size() : asked.begins[each.argument + 1]) - begin));
    }
    Question other{numbers.name, asked.begins, asked.quaternions};
    for (std::size_t i = 0; i < all.size(); ++i)
      if (numbers.is_quantity[i] || !std::isfinite(all[i]))
        put(other.line, all[i]);
      else
        put(other.line, static_cast<long long>(all[i]));
    return other;
  }

  std::mt19937_64 chance_;
};

/// The numbers of a reply, which begins with "value"; none in any other.
inline std::vector<double> numbers_in(const std::string& reply) {
  std::vector<double> numbers;
  Words words(reply);
  if (words.word() != "value") return numbers;
  while (!words.empty()) numbers.push_back(words.number());
  return numbers;
}

/// In how many of the cases that tell a function from a table the two agreed.
struct Agreement {
  int cases = 0, right = 0;
  bool is_enough() const { return cases == 0 || 2 * right > cases; }
};

/// What was asked, and the student's reply.
using Asked = std::vector<std::pair<Question, std::string>>;
using Answer = std::function<std::string(const std::string& line)>;

/// A number of an answer that tells whether it was computed, and within how much it must be right.
struct Telling {
  std::size_t which;
  double within;
};

inline bool agrees(const std::vector<double>& answer, const std::vector<double>& truth,
                   const std::vector<Telling>& telling) {
  return answer.size() == truth.size() &&
         std::all_of(telling.begin(), telling.end(), [&](const Telling& each) {
           const double found = answer[each.which], right = truth[each.which];
           return found == right || std::abs(found - right) <= each.within;
         });
}

/// What a question and its variation make of the reference's answer. Of its numbers only those tell
/// anything that move by more than twice what the student's may be off by: besides roundings and
/// the task's own `part` that is four times what the student's is off by where the check asks. So
/// whoever forgets what a check doesn't look at keeps that check's points. What moves as far as
/// what was asked could be a copy of it, and counts only where nothing else does.
struct Case {
  std::vector<Telling> telling, like_a_copy;

  Case(const std::vector<double>& asked, const std::vector<double>& varied,
       const std::vector<double>& own, const std::vector<double>& at_first,
       const std::vector<double>& truth, const std::vector<double>& near, double part,
       double rounding) {
    constexpr double roundings =
        1024;  // of the answer and of the question: far more than there are
    double size = 0;
    for (const double each : truth)
      if (std::isfinite(each)) size = std::max(size, std::abs(each));
    const bool is_comparable = at_first.size() == truth.size() && own.size() == truth.size();
    for (std::size_t i = 0; i < truth.size(); ++i) {
      double within = std::max(part, roundings * rounding) * size;
      if (near.size() == truth.size()) within += roundings * std::abs(near[i] - truth[i]);
      if (!is_comparable) {  // as of a list whose length is what was varied
        telling.push_back({i, within});
        continue;
      }
      within += 4 * std::abs(own[i] - at_first[i]);
      const double move = std::abs(truth[i] - at_first[i]);
      if (!(move > 2 * within)) continue;
      bool is_like_a_copy = false;
      for (std::size_t j = 0; j < varied.size(); ++j)
        is_like_a_copy |=
            varied[j] != asked[j] && std::abs(move - std::abs(varied[j] - asked[j])) <= within;
      (is_like_a_copy ? like_a_copy : telling).push_back({i, within});
    }
  }
};

/// Asks both about what differs from a question in one number, by chance. `part` is how far, of its
/// size, another right answer may be off, besides roundings.
inline Agreement agreement(const Asked& asked, const Answer& reference, const Answer& student,
                           Varied& varied, double part, double rounding) {
  constexpr int enough = 12;
  constexpr std::size_t most_tried = 96;
  Agreement found, copied;
  std::vector<std::pair<std::size_t, std::size_t>> places;  // of a question, and of a number in it
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::size_t numbers = Varied::Numbers(asked[i].first).values.size();
    for (std::size_t n = 0; n < numbers; ++n) places.emplace_back(i, n);
  }
  for (std::size_t tried = 0; tried < std::min(places.size(), most_tried); ++tried) {
    if (found.cases == enough) break;
    std::swap(places[tried], places[tried + varied.below(places.size() - tried)]);
    const auto& [question, reply] = asked[places[tried].first];
    // By more where a small change is taken back, as of a whole number; by less while the reference
    // refuses it.
    for (const double by : {0.125, 0.5, 0x1p-6, 0x1p-9, 0x1p-12}) {
      const Question other = varied.in(question, places[tried].second, by);
      if (other.line == question.line) continue;
      const auto truth = numbers_in(reference(other.line));
      if (truth.empty()) continue;
      const Case one(Varied::Numbers(question).values, Varied::Numbers(other).values,
                     numbers_in(reply), numbers_in(reference(question.line)), truth,
                     numbers_in(reference(varied.rounded(other, rounding).line)), part, rounding);
      if (one.telling.empty() && one.like_a_copy.empty()) break;
      const auto answer = numbers_in(student(other.line));
      Agreement& counted = one.telling.empty() ? copied : found;
      ++counted.cases;
      counted.right += agrees(answer, truth, one.telling.empty() ? one.like_a_copy : one.telling);
      break;
    }
  }
  return found.cases > 0 ? found : copied;
}

}  // namespace tumble::exercise
