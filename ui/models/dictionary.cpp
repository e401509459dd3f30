// SPDX-License-Identifier: Apache-2.0
#include "ui/models/dictionary.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>

#include "config/device_description.h"
#include "config/module_slots.h"
#include "config/slave_settings.h"
#include "protocol/coe.h"
#include "protocol/coe_data_type.h"
#include "protocol/object_value.h"
#include "support/le_number.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

namespace access = coe::access;

QString dictionaryWord(const char* text) { return QCoreApplication::translate("Dictionary", text); }

/// ESI: "PreOP", "PreOP_SafeOP", "PreOP_OP" ...; empty: everywhere.
std::uint16_t statesOf(const std::string& restriction, std::uint16_t all) {
  if (restriction.empty()) return all;
  constexpr std::uint16_t kPreop = access::kReadPreop | access::kWritePreop,
                          kSafeop = access::kReadSafeop | access::kWriteSafeop;
  const auto states = QString::fromStdString(restriction).toLower().split(u'_');
  std::uint16_t bits = 0;
  if (states.contains(QStringLiteral("preop"))) bits |= kPreop;
  if (states.contains(QStringLiteral("safeop"))) bits |= kSafeop;
  if (states.contains(QStringLiteral("op"))) bits |= access::kReadOp | access::kWriteOp;
  return bits & all;
}

DictionaryEntry entryOf(const ObjectEntry& entry, const DeviceDescription& device) {
  DictionaryEntry result;
  result.sub_index = entry.sub_index;
  result.name = QString::fromStdString(entry.name);
  result.type_name = QString::fromStdString(entry.data_type);
  result.bits = entry.bit_length;
  auto name = entry.data_type;
  const auto words = std::ranges::find(device.enums, name, &EnumDescription::name);
  if (words != device.enums.end()) {
    result.words = words->values;
    name = words->base_type;
  }
  if (const auto* type = coe::find_data_type(name)) result.type = type->code;
  if (entry.readable) result.access |= statesOf(entry.read_restrictions, access::kRead);
  if (entry.writable) result.access |= statesOf(entry.write_restrictions, access::kWrite);
  if (entry.rx_mappable) result.access |= access::kRxPdo;
  if (entry.tx_mappable) result.access |= access::kTxPdo;
  if (entry.backup) result.access |= access::kBackup;
  if (entry.setting) result.access |= access::kSettings;
  result.default_value = entry.default_data;
  result.minimum = entry.min_data;
  result.maximum = entry.max_data;
  return result;
}

void append(Dictionary& all, const std::vector<ObjectDescription>& objects, const DeviceDescription& device) {
  for (const auto& object : objects) {
    DictionaryObject one;
    one.index = object.index;
    one.name = QString::fromStdString(object.name);
    one.single = object.code == ObjectCode::kVariable && object.entries.size() == 1;
    for (const auto& entry : object.entries) one.entries.push_back(entryOf(entry, device));
    all.push_back(std::move(one));
  }
}

/// Whole numbers of at most 64 bits alone have limits that can be compared.
const coe::DataType* wholeType(const DictionaryEntry& entry) {
  const auto* type = coe::find_data_type(entry.type);
  const bool whole =
      type != nullptr && (type->kind == coe::ValueKind::kSigned || type->kind == coe::ValueKind::kUnsigned);
  return whole ? type : nullptr;
}

/// Long double holds every number of 64 bits.
long double wholeNumber(const coe::DataType& type, std::span<const std::uint8_t> bytes) {
  const auto bits = le_number(bytes);
  if (type.kind != coe::ValueKind::kSigned || bytes.empty() || bytes.size() > 8) return static_cast<long double>(bits);
  const auto shift = 64 - 8 * static_cast<int>(bytes.size());
  return static_cast<long double>(static_cast<std::int64_t>(bits << shift) >> shift);
}

struct Limits {
  long double least = 0, most = 0;
};

Limits limitsOf(const DictionaryEntry& entry, const coe::DataType& type) {
  const bool is_signed = type.kind == coe::ValueKind::kSigned;
  const auto bits = static_cast<int>(type.bits);
  Limits limits{is_signed ? -std::ldexp(1.0L, bits - 1) : 0.0L, std::ldexp(1.0L, is_signed ? bits - 1 : bits) - 1};
  if (!entry.minimum.empty()) limits.least = wholeNumber(type, entry.minimum);
  if (!entry.maximum.empty()) limits.most = wholeNumber(type, entry.maximum);
  // Many devices describe both as 0, which is no range.
  if (limits.most <= limits.least) {
    DictionaryEntry open = entry;
    open.minimum.clear();
    open.maximum.clear();
    return limitsOf(open, type);
  }
  return limits;
}

QString wholeText(long double value) {
  return value < 0 ? QString::number(static_cast<qlonglong>(value)) : QString::number(static_cast<qulonglong>(value));
}

}  // namespace

Dictionary dictionaryOf(const SlaveSettings& slave) {
  Dictionary all;
  append(all, slave.device.dictionary, slave.device);
  for (const auto& place : slot_places(slave.device)) {
    const auto ident = plugged_module(slave, place.number);
    const auto* module = ident ? slave.device.module(*ident) : nullptr;
    if (module != nullptr) append(all, module_at(*module, place).dictionary, slave.device);
  }
  std::ranges::stable_sort(all, {}, &DictionaryObject::index);
  // A module may overwrite an object of its device: the later one counts.
  const auto twice = [](const DictionaryObject& a, const DictionaryObject& b) { return a.index == b.index; };
  std::ranges::reverse(all);
  // Not std::ranges::unique: clang 14 cannot compile what libstdc++ 12 makes of it.
  all.erase(std::unique(all.begin(), all.end(), twice), all.end());
  std::ranges::reverse(all);
  return all;
}

DictionaryEntry entryOf(const coe::EntryDescription& told) {
  DictionaryEntry entry;
  entry.sub_index = told.sub_index;
  entry.name = QString::fromStdString(told.name);
  entry.type = coe::find_data_type(told.data_type) != nullptr ? told.data_type : kBytesType;
  entry.type_name = QString::fromStdString(coe::esi_type_name(told.data_type, told.bit_length));
  if (entry.type == kBytesType) entry.type_name = QString::fromStdString(data_type_name(told.data_type));
  entry.bits = told.bit_length;
  entry.access = told.access;
  if ((told.value_info & coe::value_info::kUnitType) != 0) entry.unit = told.unit_type;
  entry.default_value = told.default_value;
  entry.minimum = told.minimum;
  entry.maximum = told.maximum;
  return entry;
}

void completeFromEsi(DictionaryObject& object, const Dictionary& esi) {
  const auto known = std::ranges::find(esi, object.index, &DictionaryObject::index);
  if (known == esi.end()) return;
  if (object.name.isEmpty()) object.name = known->name;
  for (auto& entry : object.entries) {
    const auto same = std::ranges::find(known->entries, entry.sub_index, &DictionaryEntry::sub_index);
    if (same == known->entries.end()) continue;
    if (entry.name.isEmpty()) entry.name = same->name;
    if (same->bits != entry.bits) continue;  // another revision's
    entry.words = same->words;
    if (entry.minimum.empty()) entry.minimum = same->minimum;
    if (entry.maximum.empty()) entry.maximum = same->maximum;
    if (entry.default_value.empty()) entry.default_value = same->default_value;
  }
}

QString objectText(coe::ObjectAddress object) { return objectText(object.index, object.sub_index); }

QString accessText(const DictionaryEntry& entry) {
  const auto reads = entry.access & access::kRead, writes = entry.access & access::kWrite;
  if (reads == 0 && writes == 0) return noText();
  auto text = writes == 0 ? QStringLiteral("ro") : reads == 0 ? QStringLiteral("wo") : QStringLiteral("rw");
  if (writes != 0 && writes != access::kWrite) {
    QStringList states;
    if ((writes & access::kWritePreop) != 0) states << QStringLiteral("PREOP");
    if ((writes & access::kWriteSafeop) != 0) states << QStringLiteral("SAFEOP");
    if ((writes & access::kWriteOp) != 0) states << QStringLiteral("OP");
    text += QStringLiteral(" (%1)").arg(
        dictionaryWord(QT_TRANSLATE_NOOP("Dictionary", "write in %1")).arg(states.join(u'/')));
  }
  if ((entry.access & access::kRxPdo) != 0) text += QStringLiteral(", RxPDO");
  if ((entry.access & access::kTxPdo) != 0) text += QStringLiteral(", TxPDO");
  return text;
}

QString valueText(const DictionaryEntry& entry, std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {};
  const auto text = QString::fromStdString(value_text(entry.type, bytes));
  const auto* type = wholeType(entry);
  if (type == nullptr || entry.words.empty()) return text;
  const auto value = static_cast<std::int64_t>(wholeNumber(*type, bytes));
  const auto known = std::ranges::find(entry.words, value, &EnumValue::value);
  return known == entry.words.end() ? text : QStringLiteral("%1 (%2)").arg(text, QString::fromStdString(known->text));
}

QString rawText(const DictionaryEntry& entry, std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {};
  if (wholeType(entry) != nullptr && bytes.size() <= 8)
    return hexText(le_number(bytes), static_cast<int>(2 * bytes.size()));
  return QString::fromStdString(value_text(kBytesType, bytes)).toUpper();
}

QString rangeText(const DictionaryEntry& entry) {
  const auto* type = wholeType(entry);
  if (type == nullptr || type->bits == 0) {
    if (entry.bits == 0) return {};
    return entry.type == kStringType
               ? dictionaryWord(QT_TRANSLATE_NOOP("Dictionary", "text of at most %1")).arg(bitsText(entry.bits))
               : bitsText(entry.bits);
  }
  const auto limits = limitsOf(entry, *type);
  return dictionaryWord(QT_TRANSLATE_NOOP("Dictionary", "%1 to %2"))
      .arg(wholeText(limits.least), wholeText(limits.most));
}

std::optional<std::vector<std::uint8_t>> typedValue(const DictionaryEntry& entry, const QString& text) {
  auto bytes = value_bytes(entry.type, (entry.type == kStringType ? text : text.trimmed()).toStdString());
  if (!bytes) return std::nullopt;
  const auto size = (entry.bits + 7U) / 8U;
  const auto* type = wholeType(entry);
  if (type == nullptr) {
    const bool fits = size == 0 || (entry.type == kStringType ? bytes->size() <= size : bytes->size() == size);
    return fits ? std::optional(std::move(*bytes)) : std::nullopt;
  }
  // Hexadecimal digits are bits, which a signed number may have all of.
  const auto limits = limitsOf(entry, *type);
  const auto value = wholeNumber(*type, *bytes);
  if (value < limits.least || value > limits.most) return std::nullopt;
  return std::move(*bytes);
}

}  // namespace syncline::ui
