// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "eni/format/eni_style.h"
#include "eni/xml/xml_writer.h"

namespace syncline::eni {

/// XML with the number formats of ETG.2100.
class EniText {
 public:
  explicit EniText(const EniStyle& style = {});

  /// Name and value of an attribute; an empty value leaves the attribute out.
  struct Attribute {
    std::string_view name;
    std::string value;
  };

  void open(std::string_view element, const std::vector<Attribute>& attributes = {});
  void close() { xml_.close(); }
  /// Text that is not UTF-8 is taken for ISO-8859-1; characters that XML cannot carry are left out.
  void text(std::string_view element, std::string_view value);
  /// xs:int is signed: an unsigned number with the top bit set is written negative, as the schema demands.
  void number(std::string_view element, std::uint32_t value) {
    text(element, decimal(static_cast<std::int32_t>(value)));
  }
  void signed_number(std::string_view element, std::int64_t value) { text(element, decimal(value)); }
  void boolean(std::string_view element, bool value) { text(element, boolean_text(value)); }
  /// Value of an attribute that is written only when it is true.
  [[nodiscard]] std::string flag(bool value) const { return value ? std::string(boolean_text(true)) : std::string(); }
  /// Of the element that was opened last.
  void content(std::string_view value);
  /// HexDecValue: "#x1a00", 0 as "#x0".
  void hex_number(std::string_view element, std::uint32_t value);
  /// xs:hexBinary, wire order, lower case.
  void bytes(std::string_view element, std::span<const std::uint8_t> value);

  [[nodiscard]] const EniStyle& style() const { return style_; }
  [[nodiscard]] std::string take() { return xml_.take(); }
  [[nodiscard]] static std::string decimal(std::int64_t value);

 private:
  [[nodiscard]] std::string_view boolean_text(bool value) const {
    if (style_.words) return value ? "true" : "false";
    return value ? "1" : "0";
  }

  EniStyle style_;
  XmlWriter xml_;
};

}  // namespace syncline::eni
