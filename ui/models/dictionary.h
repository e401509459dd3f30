// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/object_description.h"
#include "protocol/sdo_information.h"

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

namespace syncline::coe {
struct ObjectAddress;
}  // namespace syncline::coe

/// The object dictionary of a slave as the window shows it, from the ESI or from the slave itself.
namespace syncline::ui {

struct DictionaryEntry {
  std::uint8_t sub_index = 0;
  QString name{};
  std::uint16_t type = 0;                                           // CoE data type; 0: bytes
  QString type_name{};                                              // as the source says it
  std::uint16_t bits = 0;                                           // 0: not told
  std::uint16_t access = 0;                                         // bits of coe::access
  std::uint16_t unit = 0;                                           // unit type of the entry description; 0: none
  std::vector<std::uint8_t> default_value{}, minimum{}, maximum{};  // empty: not told
  std::vector<EnumValue> words{};                                   // of an enumeration
  bool operator==(const DictionaryEntry&) const = default;
  [[nodiscard]] bool readable() const { return (access & coe::access::kRead) != 0; }
  [[nodiscard]] bool writable() const { return (access & coe::access::kWrite) != 0; }
};

struct DictionaryObject {
  std::uint16_t index = 0;
  QString name{};
  bool single = false;  // a variable: the object is its own entry
  std::vector<DictionaryEntry> entries{};
  bool operator==(const DictionaryObject&) const = default;
};
using Dictionary = std::vector<DictionaryObject>;

/// What the ESI says, with the objects of the plugged modules; index ascending.
[[nodiscard]] Dictionary dictionaryOf(const SlaveSettings& slave);
/// What the slave says of an entry.
[[nodiscard]] DictionaryEntry entryOf(const coe::EntryDescription& told);
/// The words that the ESI has for what a slave tells of itself: names of values, and of what it does not name.
void completeFromEsi(DictionaryObject& object, const Dictionary& esi);

/// "0x6040:00"
[[nodiscard]] QString objectText(coe::ObjectAddress object);
/// "rw, RxPDO"; where it can be written in some states only, they are said: "rw (write in PREOP/SAFEOP)".
[[nodiscard]] QString accessText(const DictionaryEntry& entry);
/// By its type: "12", "8 (Cyclic synchronous position)", "12 AB".
[[nodiscard]] QString valueText(const DictionaryEntry& entry, std::span<const std::uint8_t> bytes);
/// A number as one reads it, "0x0000000C"; other bytes in their order.
[[nodiscard]] QString rawText(const DictionaryEntry& entry, std::span<const std::uint8_t> bytes);
/// "0 to 65535", by type, minimum and maximum; empty where nothing limits it.
[[nodiscard]] QString rangeText(const DictionaryEntry& entry);
/// Bytes of what was typed; nothing when it is none of its type or beyond its limits.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> typedValue(const DictionaryEntry& entry, const QString& text);

}  // namespace syncline::ui
