/// @file
/// The process in which a student's code runs: it reads what is asked, calls the function, and
/// answers with what came of it. It knows no expected value.
#pragma once

#include <exercise/todo.hpp>
#include <exercise/wire.hpp>
#include <initializer_list>

namespace tumble::exercise {

/// A function and the name it is asked for by.
struct Offer {
  std::string_view name;
  void (*answer)(Words& question, std::string& reply);
};

template <class Argument>
inline constexpr bool is_changed =
    std::is_lvalue_reference_v<Argument> && !std::is_const_v<std::remove_reference_t<Argument>>;

template <class Argument>
void put_if_changed(std::string& reply, const std::remove_cvref_t<Argument>& argument) {
  if constexpr (is_changed<Argument>) put(reply, argument);
}

/// Reads the arguments, calls the function, and replies with its result and with the arguments that
/// it was allowed to change.
template <class Result, class... Arguments>
void call(Result (*function)(Arguments...), Words& question, std::string& reply) {
  std::tuple<std::remove_cvref_t<Arguments>...> arguments;
  std::apply([&](auto&... argument) { (get(question, argument), ...); }, arguments);
  std::apply(
      [&](auto&... argument) {
        if constexpr (std::is_void_v<Result>)
          function(static_cast<Arguments>(argument)...);
        else
          put(reply, function(static_cast<Arguments>(argument)...));
        (put_if_changed<Arguments>(reply, argument), ...);
      },
      arguments);
}

template <auto function>
void answer(Words& question, std::string& reply) {
  call(function, question, reply);
}

/// The reply to a question: "value" with what the function made, or what it threw.
std::string replied(Words& question, std::initializer_list<Offer> offers);

/// Answers one question after the other until there are no more.
int serve(int argument_count, char** arguments, std::initializer_list<Offer> offers);

}  // namespace tumble::exercise
