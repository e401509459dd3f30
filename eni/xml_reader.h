// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eni/xml_number.h"
#include "support/result.h"

/// Reading XML that others wrote: values with their line, the first error kept, no exceptions.
namespace syncline::eni {

/// Where errors go while a piece of a file is read. Only the first one is kept: what follows is often its consequence.
class Reading {
 public:
  explicit Reading(std::string file) : file_(std::move(file)) {}
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] bool ok() const { return !error_; }
  void fail(ErrorCode code, int line, std::string subject, std::string detail);

 private:
  std::string file_;
  std::optional<Error> error_;
};

/// One element, or none: reading from none gives empty values, so that optional branches need no test.
class Node {
 public:
  Node() = default;
  Node(const tinyxml2::XMLElement* element, Reading& reading) : element_(element), reading_(&reading) {}

  explicit operator bool() const { return element_ != nullptr; }
  [[nodiscard]] std::string_view name() const { return element_ ? element_->Name() : std::string_view{}; }
  [[nodiscard]] int line() const { return element_ ? element_->GetLineNum() : 0; }
  [[nodiscard]] Reading& reading() const { return *reading_; }
  /// The same element with its errors going elsewhere.
  [[nodiscard]] Node with(Reading& reading) const { return {element_, reading}; }

  [[nodiscard]] Node child(const char* name) const;
  /// kXmlMissingElement with the line of this element when there is none.
  [[nodiscard]] Node required(const char* name) const;
  [[nodiscard]] std::vector<Node> children(const char* name = nullptr) const;
  /// Of the children of that name the one with LcId 1033 (English), else the one without LcId, else the first.
  [[nodiscard]] Node localized(const char* name) const;

  /// Text as it stands, with CDATA, without comments.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string trimmed() const;
  [[nodiscard]] std::vector<std::uint8_t> bytes() const;  // xs:hexBinary
  /// Number of this element's text; kXmlBadValue when it is none or does not fit T.
  template <std::integral T>
  [[nodiscard]] T number() const {
    return element_ ? convert<T>(text(), name(), {}) : T{};
  }
  [[nodiscard]] bool boolean() const;

  [[nodiscard]] bool has(const char* attribute) const { return element_ && element_->Attribute(attribute) != nullptr; }
  [[nodiscard]] std::string attribute(const char* name) const;
  template <std::integral T>
  [[nodiscard]] std::optional<T> number(const char* attribute_name) const {
    if (!has(attribute_name)) return std::nullopt;
    return convert<T>(attribute(attribute_name), name(), attribute_name);
  }
  [[nodiscard]] std::optional<bool> boolean(const char* attribute_name) const;

  /// Text or number of a child; nothing when the child is absent.
  template <std::integral T>
  [[nodiscard]] std::optional<T> child_number(const char* child_name) const {
    const Node found = child(child_name);
    return found ? std::optional(found.number<T>()) : std::nullopt;
  }

  void fail(ErrorCode code, std::string detail) const;

 private:
  template <class T>
  [[nodiscard]] T convert(std::string_view value, std::string_view element, std::string_view attribute) const {
    const auto number = parse_number(value);
    if (!number) {
      bad_value(element, attribute, value, "is no number");
      return T{};
    }
    const bool negative_into_unsigned = std::unsigned_integral<T> && *number < 0;
    const bool too_big = *number > 0 && static_cast<std::uint64_t>(*number) >
                                            static_cast<std::uint64_t>(std::numeric_limits<T>::max());
    const bool too_small = std::signed_integral<T> && *number < static_cast<std::int64_t>(std::numeric_limits<T>::min());
    if (negative_into_unsigned || too_big || too_small) {
      bad_value(element, attribute, value, "is out of range");
      return T{};
    }
    return static_cast<T>(*number);
  }
  void bad_value(std::string_view element, std::string_view attribute, std::string_view value,
                 std::string_view problem) const;

  const tinyxml2::XMLElement* element_ = nullptr;
  Reading* reading_ = nullptr;
};

/// A parsed file: the tree and the encoding-corrected text behind it.
using XmlDocument = std::unique_ptr<tinyxml2::XMLDocument>;
/// kXmlMalformed with line and reason. `file_name` is for messages.
[[nodiscard]] Result<XmlDocument> parse_xml(std::string_view text, const std::string& file_name);
[[nodiscard]] Result<XmlDocument> load_xml(const std::string& path);

}  // namespace syncline::eni
