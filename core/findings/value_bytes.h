// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "findings/reason_of.h"
#include "reasons/reason.h"

/// Values one behind the other as zigzag LEB128 and counted texts, for what a recording holds of events and findings,
/// and the device catalogue of warnings.
/// What a later program has put behind them is passed over, and what an earlier one had not yet stays as it is.
namespace syncline {

/// Largest value of each enumeration that is recorded: what is larger was not written by this program.
template <class Enum>
inline constexpr int kLargest = -1;

/// A text that is kept in a class of its own: core/channels' SharedText.
template <class T>
concept KeptText = requires(const T& text) {
  { text.str() } -> std::convertible_to<std::string_view>;
};

/// A reason by its words, behind its sentence: programs that know them say it in their language, older ones and those
/// that have other words as it was said.
struct WordedReason {
  Reason& reason;
};

class ValueWriter {
 public:
  template <class... Fields>
  void operator()(const Fields&... fields) {
    (put(fields), ...);
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  template <class T>
  requires std::integral<T>
  void put(T value) {
    const auto wide = static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
    auto rest = (wide << 1) ^ (0 - (wide >> 63));
    for (; rest >= 0x80; rest >>= 7) bytes_ += static_cast<char>(rest | 0x80);
    bytes_ += static_cast<char>(rest);
  }
  template <class T>
  requires std::is_enum_v<T>
  void put(T value) {
    static_assert(kLargest<T> >= 0, "an enumeration without its largest value");
    put(static_cast<std::int64_t>(value));
  }
  void put(std::string_view text) {
    put(text.size());
    bytes_ += text;
  }
  void put(const std::string& text) { put(std::string_view(text)); }
  template <KeptText T>
  void put(const T& text) {
    put(std::string_view(text.str()));
  }
  void put(const Reason& reason) { put(reason.text()); }
  void put(const WordedReason& worded) { put_words(worded.reason); }
  void put_words(const Reason& reason) {
    put(reason.words());
    if (reason.words().empty()) return put(reason.text());
    put(reason.given().size());
    for (const Reason& given : reason.given()) put_words(given);
  }
  template <class T, std::size_t size>
  void put(const std::array<T, size>& values) {
    for (const auto& value : values) put(value);
  }

  std::string bytes_;
};

/// Takes them off the front; good() is false from the first on that is none.
class ValueReader {
 public:
  explicit ValueReader(std::string_view bytes) : bytes_(bytes) {}
  template <class... Fields>
  void operator()(Fields&... fields) {
    (take(fields), ...);
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  template <class T>
  requires std::integral<T>
  void take(T& value) {
    if (bytes_.empty() || !good_) return;
    const auto number = static_cast<std::int64_t>(next());
    value = static_cast<T>(number);
    good_ = good_ && static_cast<std::int64_t>(value) == number;
  }
  template <class T>
  requires std::is_enum_v<T>
  void take(T& value) {
    auto number = static_cast<std::int64_t>(value);
    take(number);
    good_ = good_ && number >= 0 && number <= kLargest<T>;
    if (good_) value = static_cast<T>(number);
  }
  void take(std::string& text) {
    std::uint64_t size = 0;
    take(size);
    good_ = good_ && size <= bytes_.size();
    if (!good_) return;
    text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
  }
  void take(Reason& reason) {
    std::string text;
    take(text);
    reason = Reason::phrase(text);
  }
  void take(WordedReason& worded) {
    if (bytes_.empty() || !good_) return;
    auto reason = take_words(0);
    if (good_ && reason && reason->text() == worded.reason.text()) worded.reason = *std::move(reason);
  }
  /// Nothing where the program has other words today.
  std::optional<Reason> take_words(int depth) {
    constexpr int kDeepest = 8;
    constexpr std::uint64_t kMost = 16;
    good_ = good_ && !bytes_.empty();
    if (!good_) return std::nullopt;
    std::string words;
    take(words);
    if (words.empty()) {
      take(words);
      return Reason::verbatim(std::move(words));
    }
    std::uint64_t count = 0;
    take(count);
    good_ = good_ && count <= kMost && depth < kDeepest;
    std::vector<Reason> given;
    bool known = true;
    for (std::uint64_t i = 0; good_ && i < count; ++i) {
      auto one = take_words(depth + 1);
      known = known && one;
      if (one) given.push_back(*std::move(one));
    }
    return known ? reason_of_any_words(words, std::move(given)) : std::nullopt;
  }
  template <KeptText T>
  void take(T& kept) {
    std::string text;
    take(text);
    kept = T(std::move(text));
  }
  template <class T, std::size_t size>
  void take(std::array<T, size>& values) {
    for (std::size_t i = 0; i < size; ++i) take(values[i]);
  }
  std::uint64_t next() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && !bytes_.empty(); shift += 7) {
      const auto byte = static_cast<std::uint8_t>(bytes_.front());
      bytes_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80) return (value >> 1) ^ (0 - (value & 1));
    }
    good_ = false;
    return 0;
  }

  std::string_view bytes_;
  bool good_ = true;
};

}  // namespace syncline
