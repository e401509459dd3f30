// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "eni/xml/xml_number.h"
#include "eni/xml/xml_writer.h"

/// Attributes and elements of ESI files that stand only where there is something to say.
namespace syncline::eni {

inline std::string decimal(std::int64_t value) { return fmt::format("{}", value); }

inline void flag(XmlWriter& xml, std::string_view name, bool value) {
  if (value) xml.attribute(name, "1");
}
template <class T>
void optional_attribute(XmlWriter& xml, std::string_view name, const std::optional<T>& value) {
  if (value) xml.attribute(name, decimal(*value));
}
inline void optional_flag(XmlWriter& xml, std::string_view name, const std::optional<bool>& value) {
  if (value) xml.attribute(name, *value ? "1" : "0");
}
inline void hex_attribute(XmlWriter& xml, std::string_view name, const std::optional<std::uint32_t>& value) {
  if (value) xml.attribute(name, hex_dec(*value, 8));
}
inline void text_attribute(XmlWriter& xml, std::string_view name, std::string_view value) {
  if (!value.empty()) xml.attribute(name, value);
}
inline void text_element(XmlWriter& xml, std::string_view name, std::string_view value) {
  if (!value.empty()) xml.element(name, value);
}
template <class T>
void optional_element(XmlWriter& xml, std::string_view name, const std::optional<T>& value) {
  if (value) xml.element(name, decimal(*value));
}
/// <Index DependOnSlot="1">#x6000</Index>
inline void index_element(XmlWriter& xml, std::string_view name, std::uint16_t index, bool by_slot,
                          bool by_slot_group) {
  xml.open(name);
  flag(xml, "DependOnSlot", by_slot);
  flag(xml, "DependOnSlotGroup", by_slot_group);
  xml.text(hex_dec(index)).close();
}

}  // namespace syncline::eni
