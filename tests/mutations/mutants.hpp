/// @file
/// What the switched copies of the headers call: each computes what stood there, or, in the one
/// mutant that was chosen, what the mutant says. Each also notes that it was reached.
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <utility>

namespace tumble_mutants {

inline constexpr int most = 1 << 17;
/// The mutant that runs; 0 if none does.
extern int chosen_number;
/// Of each mutant: 1 if it was reached, 2 if only where its change would not compile, as a
/// product's division by a matrix.
extern unsigned char seen[most];

[[gnu::always_inline]] constexpr bool chosen(int number) {
  if (std::is_constant_evaluated()) return false;
  seen[number] = 1;
  return number == chosen_number;
}

constexpr void note_no_such(int number) {
  if (!std::is_constant_evaluated() && seen[number] == 0) seen[number] = 2;
}

template <class T, class = void>
struct PlainOf {
  using Type = std::decay_t<T>;
};
template <class T>
struct PlainOf<T, std::void_t<typename std::decay_t<T>::PlainObject>> {
  using Type = typename std::decay_t<T>::PlainObject;
};
/// A value of its own: of an expression of Eigen's, what it comes to.
template <class T>
using Plain = typename PlainOf<T>::Type;

#define TUMBLE_MUTANTS_BINARY(name, original, other)                             \
  template <class A, class B>                                                    \
  constexpr auto name(int number, A&& a, B&& b)->Plain<decltype(a original b)> { \
    using Result = Plain<decltype(a original b)>;                                \
    if constexpr (requires { Result(a other b); }) {                             \
      if (chosen(number)) return Result(a other b);                              \
    } else {                                                                     \
      note_no_such(number);                                                      \
    }                                                                            \
    return a original b;                                                         \
  }
TUMBLE_MUTANTS_BINARY(plus, +, -)
TUMBLE_MUTANTS_BINARY(minus, -, +)
TUMBLE_MUTANTS_BINARY(times, *, /)
TUMBLE_MUTANTS_BINARY(divided_by, /, *)
TUMBLE_MUTANTS_BINARY(less, <, <=)
TUMBLE_MUTANTS_BINARY(less_equal, <=, <)
TUMBLE_MUTANTS_BINARY(greater, >, >=)
TUMBLE_MUTANTS_BINARY(greater_equal, >=, >)
TUMBLE_MUTANTS_BINARY(equal, ==, !=)
TUMBLE_MUTANTS_BINARY(not_equal, !=, ==)

#define TUMBLE_MUTANTS_ASSIGN(name, original, other)        \
  template <class A, class B>                               \
  constexpr decltype(auto) name(int number, A&& a, B&& b) { \
    if constexpr (requires { a other b; }) {                \
      if (chosen(number)) return a other b;                 \
    } else {                                                \
      note_no_such(number);                                 \
    }                                                       \
    return a original b;                                    \
  }
TUMBLE_MUTANTS_ASSIGN(take_from, -=, +=)
TUMBLE_MUTANTS_ASSIGN(multiply, *=, /=)
TUMBLE_MUTANTS_ASSIGN(divide, /=, *=)

/// Adds; or takes away; or forgets what was there.
template <class A, class B>
constexpr decltype(auto) add_to(int number, A&& a, B&& b) {
  if constexpr (requires { a -= b; }) {
    if (chosen(number)) return a -= b;
  } else {
    note_no_such(number);
  }
  if (chosen(number + 1)) {
    a = b;
    using Result = decltype(a += b);
    return static_cast<Result>(a);
  }
  return a += b;
}

template <class A>
constexpr Plain<decltype(-std::declval<A>())> opposite(int number, A&& a) {
  if (chosen(number)) return a;
  return -a;
}

template <class A>
constexpr auto inverse(int number, A&& a) {
  using Result = std::decay_t<decltype(!a)>;
  if constexpr (std::is_same_v<Result, bool>)
    return static_cast<bool>(a) == chosen(number);
  else
    return chosen(number) ? Result(a) : Result(!a);
}

#define TUMBLE_MUTANTS_LOGICAL(name, original, other)                     \
  template <class A, class B>                                             \
  constexpr auto name(int number, A&& a, const B& b) {                    \
    using Result = std::decay_t<decltype(a original b())>;                \
    return chosen(number) ? Result(a other b()) : Result(a original b()); \
  }
TUMBLE_MUTANTS_LOGICAL(both, &&, ||)
TUMBLE_MUTANTS_LOGICAL(either_of, ||, &&)

template <class A>
constexpr bool negated_if(int number, A&& a) {
  return static_cast<bool>(a) != chosen(number);
}

template <class A>
constexpr bool false_if(int number, A&& a) {
  return static_cast<bool>(a) && !chosen(number);
}

template <class A>
constexpr bool negated_or_false_if(int number, A&& a) {
  if (chosen(number + 1)) return false;
  return static_cast<bool>(a) != chosen(number);
}

template <class T>
constexpr T number(int number, T original, std::type_identity_t<T> other) {
  return chosen(number) ? other : original;
}

template <class T>
constexpr T number(int number, T original, std::type_identity_t<T> other,
                   std::type_identity_t<T> third) {
  if (chosen(number + 1)) return third;
  return chosen(number) ? other : original;
}

/// Where the compiler must not compute the number, but the program when it starts.
template <class T>
[[gnu::noinline]] T late_number(int number, T original, std::type_identity_t<T> other) {
  return chosen(number) ? other : original;
}

template <class T>
[[gnu::noinline]] T late_number(int number, T original, std::type_identity_t<T> other,
                                std::type_identity_t<T> third) {
  if (chosen(number + 1)) return third;
  return chosen(number) ? other : original;
}

/// The first of two; the second, if they are of one type. A function that changes the first gets
/// the second as if it, too, could be changed.
template <class A, class B>
constexpr decltype(auto) first_of(int number, A&& a, B&& b) {
  if constexpr (std::is_lvalue_reference_v<A> && std::is_same_v<std::decay_t<A>, std::decay_t<B>>) {
    if (chosen(number)) return const_cast<A>(static_cast<const std::decay_t<B>&>(b));
    return std::forward<A>(a);
  } else if constexpr (std::is_same_v<Plain<A>, Plain<B>> &&
                       std::is_copy_constructible_v<Plain<A>>) {
    if (chosen(number)) return Plain<A>(b);
    return Plain<A>(a);
  } else {
    note_no_such(number);
    if constexpr (std::is_lvalue_reference_v<A>)
      return std::forward<A>(a);
    else  // whoever calls may outlive it
      return std::remove_cv_t<A>(std::forward<A>(a));
  }
}

/// What stands for itself as long as it lives, and is moved out where it is part of something that
/// is about to go, such as body(i).top.
template <class T>
constexpr T kept(T&& value) {
  return static_cast<T&&>(value);
}

/// The same where each is a call that must not be made without need.
template <class A, class B>
constexpr decltype(auto) first_called(int number, const A& a, const B& b) {
  using First = decltype(a());
  using Second = decltype(b());
  if constexpr (std::is_same_v<First, Second>) {
    if (chosen(number)) return b();
    return a();
  } else if constexpr (std::is_lvalue_reference_v<First> && std::is_lvalue_reference_v<Second> &&
                       std::is_same_v<std::decay_t<First>, std::decay_t<Second>>) {
    if (chosen(number)) return const_cast<First>(static_cast<const std::decay_t<Second>&>(b()));
    return a();
  } else if constexpr (std::is_same_v<Plain<First>, Plain<Second>> &&
                       std::is_copy_constructible_v<Plain<First>>) {
    if (chosen(number)) return Plain<First>(b());
    return Plain<First>(a());
  } else {
    note_no_such(number);
    return a();
  }
}

}  // namespace tumble_mutants
