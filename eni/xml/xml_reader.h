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

#include "eni/xml/file_warning.h"
#include "eni/xml/xml_number.h"
#include "reasons/because.h"
#include "support/result.h"

/// Reading XML that others wrote: values with their line, the first error kept, no exceptions.
namespace syncline::eni {

/// Where errors go while a piece of a file is read. Only the first one is kept: what follows is often its consequence.
class Reading {
 public:
  static constexpr int kEnglish = 1033;  // LcId: the Windows language code that ESI files use

  explicit Reading(std::string file) : file_(std::move(file)) {}
  /// Sloppy values whose meaning is clear are taken, with a warning in `warnings`; texts are in `language` where they
  /// can.
  Reading(std::string file, FileWarnings& warnings, int language = kEnglish)
      : file_(std::move(file)), warnings_(&warnings), language_(language) {}
  /// For a part of the same file whose errors must not take the rest with it.
  [[nodiscard]] Reading of_part() const { return of_file(file_); }
  /// For another file that this one refers to.
  [[nodiscard]] Reading of_file(const std::string& file) const;

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] int language() const { return language_; }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] bool ok() const { return !error_; }
  [[nodiscard]] bool tolerant() const { return warnings_ != nullptr; }
  void fail(ErrorCode code, int line, std::string subject, Reason detail);
  void fail(const Error& error);
  void warn(int line, std::string element, Reason reason);
  /// "0x1A00", which ETG.2000 writes "#x1A00": told once a file, because it is in all of it or nowhere.
  void warn_of_prefix(int line, std::string element);

 private:
  std::string file_;
  std::optional<Error> error_;
  FileWarnings* warnings_ = nullptr;
  std::shared_ptr<bool> told_of_prefix_ = std::make_shared<bool>(false);  // shared by the parts of a file
  int language_ = kEnglish;
};

/// Of the file: a document may be a part of one, which begins in another line than 1.
[[nodiscard]] int line_of(const tinyxml2::XMLElement& element);
void set_first_line(tinyxml2::XMLDocument& document, int line);

/// One element, or none: reading from none gives empty values, so that optional branches need no test.
class Node {
 public:
  Node() = default;
  Node(const tinyxml2::XMLElement* element, Reading& reading) : element_(element), reading_(&reading) {}

  explicit operator bool() const { return element_ != nullptr; }
  [[nodiscard]] std::string_view name() const { return element_ ? element_->Name() : std::string_view{}; }
  [[nodiscard]] int line() const { return element_ ? line_of(*element_) : 0; }
  [[nodiscard]] Reading& reading() const { return *reading_; }
  [[nodiscard]] const tinyxml2::XMLElement* element() const { return element_; }
  /// The same element with its errors going elsewhere.
  [[nodiscard]] Node with(Reading& reading) const { return {element_, reading}; }

  [[nodiscard]] Node child(const char* name) const;
  /// kXmlMissingElement with the line of this element when there is none.
  [[nodiscard]] Node required(const char* name) const;
  [[nodiscard]] std::vector<Node> children(const char* name = nullptr) const;
  /// Of the children of that name the one in the reading's language, else in English, else without LcId, else the
  /// first.
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

  void fail(ErrorCode code, Reason detail) const;
  void warn(Reason reason) const;
  [[nodiscard]] bool has_children() const { return element_ != nullptr && element_->FirstChildElement() != nullptr; }

 private:
  template <class T>
  [[nodiscard]] T convert(std::string_view value, std::string_view element, std::string_view attribute) const {
    auto number = parse_number(value);
    if (number && reading_->tolerant() && value.find("0x") == 0) reading_->warn_of_prefix(line(), std::string(element));
    if (!number) number = sloppy_number(element, attribute, value);
    if (!number) {
      bad_value(element, attribute, value, "\"{text}\" is no number");
      return T{};
    }
    const bool negative_into_unsigned = std::unsigned_integral<T> && *number < 0;
    const bool too_big =
        *number > 0 && static_cast<std::uint64_t>(*number) > static_cast<std::uint64_t>(std::numeric_limits<T>::max());
    const bool too_small =
        std::signed_integral<T> && *number < static_cast<std::int64_t>(std::numeric_limits<T>::min());
    if (negative_into_unsigned || too_big || too_small) {
      bad_value(element, attribute, value, "\"{text}\" is out of range");
      return T{};
    }
    return static_cast<T>(*number);
  }
  /// In a tolerant reading: what else people write for a number.
  [[nodiscard]] std::optional<std::int64_t> sloppy_number(std::string_view element, std::string_view attribute,
                                                          std::string_view value) const;
  void bad_value(std::string_view element, std::string_view attribute, std::string_view value,
                 ReasonRow<1> problem) const;

  const tinyxml2::XMLElement* element_ = nullptr;
  Reading* reading_ = nullptr;
};

/// A parsed file: the tree and the encoding-corrected text behind it.
using XmlDocument = std::unique_ptr<tinyxml2::XMLDocument>;
/// kXmlMalformed with line and reason, kFileLimit (xml_limits.h). `file_name` is for messages.
[[nodiscard]] Result<XmlDocument> parse_xml(std::string_view text, const std::string& file_name);
/// The same of a text that is UTF-8 and within the limits.
[[nodiscard]] Result<XmlDocument> parse_utf8(std::string_view text, const std::string& file_name);
[[nodiscard]] Result<XmlDocument> load_xml(const std::string& path);

}  // namespace syncline::eni
