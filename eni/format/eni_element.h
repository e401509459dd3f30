// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "eni/xml/xml_reader.h"

namespace syncline::eni {

/// SyncManagers of an ESC (data sheet, section II, 0x0800 to 0x087F).
inline constexpr int kMaxSyncManagers = 16;

/// An element of an ENI file, or none: every access on a missing element gives the default. Takes the forms that the
/// field's files use beyond the schema; what it cannot take is kXmlBadValue with the element and its line.
class EniChildren;
class EniElement {
 public:
  EniElement() = default;
  explicit EniElement(Node node) : node_(node) {}

  explicit operator bool() const { return static_cast<bool>(node_); }
  [[nodiscard]] std::string_view name() const { return node_.name(); }
  [[nodiscard]] EniElement child(const char* name) const { return EniElement(node_.child(name)); }
  /// The child; a missing one is an error that names it.
  [[nodiscard]] EniElement required(const char* name) const { return EniElement(node_.required(name)); }
  /// Those of that name, as far as the reading has come without an error: what follows one is of no use to anybody.
  [[nodiscard]] EniChildren children(const char* name) const;

  [[nodiscard]] std::string text() const { return node_.text(); }
  [[nodiscard]] std::string attribute(const char* name) const { return node_.attribute(name); }
  [[nodiscard]] std::string text_of(const char* child_name) const { return child(child_name).text(); }

  /// Decimal, "#x.." or "0x..", negative where a tool wrote a large unsigned number as xs:int.
  template <std::integral T>
  [[nodiscard]] T number() const {
    return convert<T>(node_.text());
  }
  template <std::integral T>
  [[nodiscard]] T number_of(const char* child_name, T otherwise = 0) const {
    const EniElement found = child(child_name);
    return found ? found.number<T>() : otherwise;
  }
  template <std::integral T>
  [[nodiscard]] std::optional<T> optional_number_of(const char* child_name) const {
    const EniElement found = child(child_name);
    return found ? std::optional(found.number<T>()) : std::nullopt;
  }
  template <std::integral T>
  [[nodiscard]] std::optional<T> number_attribute(const char* attribute_name) const {
    return node_.has(attribute_name) ? std::optional(convert<T>(attribute(attribute_name))) : std::nullopt;
  }
  [[nodiscard]] bool boolean() const { return node_ && node_.boolean(); }
  [[nodiscard]] bool boolean_of(const char* child_name) const { return child(child_name).boolean(); }
  [[nodiscard]] bool boolean_attribute(const char* attribute_name) const {
    return node_.boolean(attribute_name).value_or(false);
  }
  /// xs:hexBinary; "0x" in front and ':' or '-' between bytes are tolerated.
  [[nodiscard]] std::vector<std::uint8_t> bytes() const;

  [[nodiscard]] const Node& node() const { return node_; }
  [[nodiscard]] const tinyxml2::XMLElement* element() const { return node_.element(); }
  /// With the value that cannot be used.
  void report(ErrorCode code, std::string value) const { node_.fail(code, Reason::verbatim(std::move(value))); }

 private:
  template <std::integral T>
  [[nodiscard]] T convert(const std::string& value) const {
    if (!node_) {
      return T{};
    }
    constexpr auto kMaximum = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
    constexpr std::int64_t kMinimum = std::numeric_limits<std::make_signed_t<T>>::min();
    const auto number = parse_number(value);
    if (!number || *number < kMinimum || (*number > 0 && static_cast<std::uint64_t>(*number) > kMaximum)) {
      report(ErrorCode::kXmlBadValue, "\"" + value + "\"");
      return T{};
    }
    return static_cast<T>(*number);
  }

  Node node_;
};

/// A file may have a million of them: they are walked, not gathered.
class EniChildren {
 public:
  class Iterator {
   public:
    using value_type = EniElement;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(Node node, const char* name) : node_(node), name_(name) {}
    EniElement operator*() const { return EniElement(node_); }
    Iterator& operator++();
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return node_.element() == other.node_.element(); }

   private:
    Node node_;
    const char* name_ = nullptr;
  };

  EniChildren(const Node& parent, const char* name) : first_(parent.child(name), name) {}
  [[nodiscard]] Iterator begin() const { return first_; }
  [[nodiscard]] Iterator end() const { return {}; }
  [[nodiscard]] bool empty() const { return begin() == end(); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(std::distance(begin(), end())); }

 private:
  Iterator first_;
};

/// What `read` makes of each of the children, in no more memory than they take.
template <class Read>
[[nodiscard]] auto read_each(const EniChildren& children, Read read) {
  std::vector<std::decay_t<decltype(read(*children.begin()))>> out;
  out.reserve(children.size());
  for (const EniElement& element : children) out.push_back(read(element));
  return out;
}

}  // namespace syncline::eni
