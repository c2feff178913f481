/// @file
/// Answers that take no thought, in the place of a student's code: zero, one, no number, infinity,
/// the input back, a refusal. The audit hands them to every check; none may earn a point.
#pragma once

#include <array>
#include <exercise/answers.hpp>
#include <limits>

namespace tumble::exercise {

/// A function of the header that may answer trivially.
struct Place {
  std::string_view name;
  bool has_own_code;  ///< the starter has no todo() in it
  bool may_be_left;   ///< it returns nothing, or returns something though its todo() does nothing
};

struct TrivialAnswer {
  enum Kind {
    own_code,
    nothing,
    number,
    unit,
    default_value,
    echo,
    difference,
    refusal,
    other_exception
  };
  std::string_view name;
  Kind kind;
  double value = 0;  ///< of `number`: what every component gets
  int index = 0;     ///< of `unit`: the axis; else which of the values that came in
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// Its square is 0, so that a quotient by a length of such numbers is infinite; and the other end.
inline constexpr double smallest = std::numeric_limits<double>::denorm_min(),
                        largest_number = std::numeric_limits<double>::max();
inline constexpr auto trivial_answers = std::to_array<TrivialAnswer>({
    {"its own code", TrivialAnswer::own_code},
    {"nothing", TrivialAnswer::nothing},
    {"0", TrivialAnswer::number, 0},
    {"1", TrivialAnswer::number, 1},
    {"-1", TrivialAnswer::number, -1},
    {"0.5", TrivialAnswer::number, 0.5},
    {"2", TrivialAnswer::number, 2},
    {"1000", TrivialAnswer::number, 1000},
    {"NaN", TrivialAnswer::number, std::numeric_limits<double>::quiet_NaN()},
    {"infinity", TrivialAnswer::number, infinity},
    {"-infinity", TrivialAnswer::number, -infinity},
    {"the smallest number", TrivialAnswer::number, smallest},
    {"minus the smallest number", TrivialAnswer::number, -smallest},
    {"the largest number", TrivialAnswer::number, largest_number},
    {"minus the largest number", TrivialAnswer::number, -largest_number},
    {"the unit along x", TrivialAnswer::unit, 0, 0},
    {"the unit along y", TrivialAnswer::unit, 0, 1},
    {"the unit along z", TrivialAnswer::unit, 0, 2},
    {"a default value", TrivialAnswer::default_value},
    {"the 1st input back", TrivialAnswer::echo, 0, 0},
    {"the 2nd input back", TrivialAnswer::echo, 0, 1},
    {"the 3rd input back", TrivialAnswer::echo, 0, 2},
    {"the 4th input back", TrivialAnswer::echo, 0, 3},
    {"the 5th input back", TrivialAnswer::echo, 0, 4},
    {"the 6th input back", TrivialAnswer::echo, 0, 5},
    {"the 7th input back", TrivialAnswer::echo, 0, 6},
    {"the 8th input back", TrivialAnswer::echo, 0, 7},
    {"the 2nd input less the 1st", TrivialAnswer::difference, 0, 1},
    {"the 3rd input less the 1st", TrivialAnswer::difference, 0, 2},
    {"the 4th input less the 1st", TrivialAnswer::difference, 0, 3},
    {"a refusal", TrivialAnswer::refusal},
    {"another exception", TrivialAnswer::other_exception},
});

/// Thrown where the search has yet to choose what a place answers.
struct NotChosen {};
/// Thrown where an answer has no meaning, such as a unit vector for a number.
struct NoSuchAnswer {};

/// What is chosen for a place. Notes the place and throws NotChosen if nothing is yet.
const TrivialAnswer& chosen_for(int place);

/// Whether the place answers trivially, and not by the code that stands there.
inline bool is_trivial(int place) {
  const auto kind = chosen_for(place).kind;
  return kind != TrivialAnswer::own_code && kind != TrivialAnswer::nothing;
}

template <class Number>
void fill(Number& value, double number) requires std::is_arithmetic_v<Number> {
  if constexpr (std::is_integral_v<Number> && !std::is_same_v<Number, bool>)
    number = number > 1e9    ? double(std::numeric_limits<int>::max())
             : number > -1e9 ? number
                             : double(std::numeric_limits<int>::min());  // a NaN, too
  value = static_cast<Number>(number);
}
inline void fill(std::string_view& text, double number) {
  text = number == 0 ? "" : "for no reason";
}
template <class Real, int rows, int columns>
void fill(Eigen::Matrix<Real, rows, columns>& matrix, double number) {
  matrix.setConstant(static_cast<Real>(number));
}
template <class Pack>
void fill(Pack& pack, double number) requires requires {
  pack.lanes;
}
{
  fill(pack.lanes[0], number);
  pack = Pack(pack.lanes[0]);
}
template <class PairPush>
void fill(PairPush& push, double number) requires requires {
  push.force_on_first;
}
{
  fill(push.force_on_first, number);
  fill(push.torque_on_first, number);
  fill(push.torque_on_second, number);
}
template <class Struct>
auto fill(Struct& value, double number) -> decltype(fields(value), void()) {
  std::apply([number](auto&... field) { (fill(field, number), ...); }, fields(value));
}
template <class Item>
void fill(std::vector<Item>& items, double number) {
  for (Item& item : items) fill(item, number);
}

template <class Value>
void fill_unit(Value&, int) {
  throw NoSuchAnswer();
}
template <class Real, int rows, int columns>
void fill_unit(Eigen::Matrix<Real, rows, columns>& matrix, int axis) {
  matrix.setZero();
  if constexpr (columns == 1)
    matrix[axis] = 1;
  else
    matrix.setIdentity();
}
template <class Quaternion>
void fill_unit(Quaternion& q, int axis) requires requires {
  q.imaginary;
}
{
  q.real = 0;
  fill_unit(q.imaginary, axis);
}
template <class Item>
void fill_unit(std::vector<Item>& items, int axis) {
  for (Item& item : items) fill_unit(item, axis);
}

/// Counts the values of one type among the arguments and in them, and keeps one of them.
template <class Result>
struct Echo {
  int wanted = 0;
  Result found{};

  template <class Value>
  void look_at(const Value& value) {
    if constexpr (std::is_same_v<Value, Result>) {
      if (wanted-- == 0) found = value;
    } else if constexpr (requires { fields(value); }) {
      std::apply([this](const auto&... field) { (look_at(field), ...); }, fields(value));
    } else if constexpr (requires {
                           value.data();
                           value.size();
                           value[0];
                         }) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(value.size()) && i < 3; ++i)
        look_at(value.data()[i]);
    }
  }
};

/// How long a list becomes: as long as one that came in, or as a whole number that came in says.
template <class... Arguments>
std::size_t length_from(const Arguments&... arguments) {
  std::size_t length = 3;
  const auto look = [&length](const auto& argument) {
    if constexpr (std::is_same_v<decltype(argument), const int&>)
      length = static_cast<std::size_t>(std::max(argument, 0));
    else if constexpr (requires { argument.push_back(argument[0]); })
      length = argument.size();
  };
  (look(arguments), ...);
  return length;
}

template <class Result>
void take_on(Result& result, const TrivialAnswer& answer) {
  if (answer.kind == TrivialAnswer::number)
    fill(result, answer.value);
  else if (answer.kind == TrivialAnswer::unit)
    fill_unit(result, answer.index);
  else
    throw NoSuchAnswer();
}

/// The trivial answer that is chosen for a place: the result, or what becomes of the arguments that
/// a void function may change.
template <class Result, class... Arguments>
Result trivial(int place, Arguments&... arguments) {
  const TrivialAnswer& answer = chosen_for(place);
  if (answer.kind == TrivialAnswer::refusal) throw std::invalid_argument("no");
  if (answer.kind == TrivialAnswer::other_exception) throw std::runtime_error("no");
  if constexpr (std::is_void_v<Result>) {
    const auto change = [&answer](auto& argument) {
      if constexpr (!std::is_const_v<std::remove_reference_t<decltype(argument)>>)
        take_on(argument, answer);
    };
    (change(arguments), ...);
  } else {
    const auto input = [&](int index) {
      Echo<Result> echo{index};
      (echo.look_at(arguments), ...);
      if (echo.wanted >= 0) throw NoSuchAnswer();
      return echo.found;
    };
    if (answer.kind == TrivialAnswer::echo) return input(answer.index);
    if (answer.kind == TrivialAnswer::difference) {
      if constexpr (requires { Result(input(1) - input(0)); })
        return Result(input(answer.index) - input(0));
      throw NoSuchAnswer();
    }
    Result result{};
    if constexpr (requires { result.setZero(); }) result.setZero();
    if (answer.kind == TrivialAnswer::default_value) return result;
    if constexpr (requires {
                    result.resize(3);
                    result.push_back(result[0]);
                  })
      result.resize(length_from(arguments...));
    take_on(result, answer);
    return result;
  }
}

/// Tries every combination of trivial answers on every check, and prints those that pass.
int search(int argument_count, char** arguments, std::initializer_list<Place> places,
           std::initializer_list<Offer> offers);

}  // namespace tumble::exercise
