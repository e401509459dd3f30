// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <tl/expected.hpp>
#include <type_traits>
#include <utility>

namespace syncline {

template <class T>
inline constexpr bool is_expected = false;

/// tl::expected whose copies throw std::bad_alloc where there is no memory for them, like any other copy: tl::expected
/// copies its error in a function that is noexcept, which then ends the program.
template <class T, class E>
class Expected : public tl::expected<T, E> {
  static constexpr bool kMovesQuietly =
      std::is_nothrow_move_constructible_v<E> && (std::is_void_v<T> || std::is_nothrow_move_constructible_v<T>);

 public:
  using Base = tl::expected<T, E>;
  Expected() = default;
  Expected(const Expected& other) requires(std::is_void_v<T> || std::copy_constructible<T>) : Base(copy_of(other)) {}
  Expected(Expected&&) noexcept(kMovesQuietly) = default;  // NOLINT(performance-noexcept-move-constructor): as T is
  Expected& operator=(const Expected& other) requires(std::is_void_v<T> || std::copy_constructible<T>) {
    if (this != &other) *this = Expected(other);
    return *this;
  }
  Expected& operator=(Expected&&) noexcept(kMovesQuietly) = default;  // NOLINT(performance-noexcept-move-constructor)
  ~Expected() = default;

  /// What tl::expected's own functions answer, such as map().
  template <std::same_as<Base> Answer>
  Expected(Answer base) : Base(std::move(base)) {}
  template <class U, class F>
  requires(!std::same_as<Expected<U, F>, Expected> && std::constructible_from<Base, tl::expected<U, F>>)
      Expected(Expected<U, F>&& other)
      : Base(static_cast<tl::expected<U, F>&&>(other)) {}
  template <class F>
  requires std::constructible_from<E, F> Expected(tl::unexpected<F> error)
      : Base(tl::unexpected<E>(std::move(error.value()))) {}
  template <class U = T>  // NOLINTNEXTLINE(bugprone-forwarding-reference-overload): constrained
  requires(!is_expected<std::remove_cvref_t<U>> && std::convertible_to<U&&, T>) Expected(U&& value)
      : Base(std::forward<U>(value)) {}

  /// What `next` answers, or the error that there is already.
  template <class F>
  requires std::is_void_v<T> std::invoke_result_t<F> and_then(F&& next) && {
    if (!*this) return tl::unexpected<E>(std::move(this->error()));
    return std::forward<F>(next)();
  }

  /// With a value tl::expected compares itself.
  template <std::same_as<Expected> One, std::same_as<Expected> Other>
  friend bool operator==(const One& a, const Other& b) {
    if (!a || !b) return a.has_value() == b.has_value() && a.error() == b.error();
    if constexpr (std::is_void_v<T>) {
      return true;
    } else {
      return *a == *b;
    }
  }

 private:
  [[nodiscard]] static Base copy_of(const Base& other) {
    if (!other) return tl::unexpected<E>(other.error());
    if constexpr (std::is_void_v<T>) {
      return {};
    } else {
      return *other;
    }
  }
};

template <class T, class E>
inline constexpr bool is_expected<Expected<T, E>> = true;
template <class T, class E>
inline constexpr bool is_expected<tl::expected<T, E>> = true;

}  // namespace syncline
