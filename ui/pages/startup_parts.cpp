// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/startup_parts.h"

#include <algorithm>

#include "config/device_description.h"
#include "config/startup_origin.h"
#include "protocol/coe_data_type.h"
#include "protocol/object_value.h"
#include "protocol/soe.h"
#include "settings/startup_text.h"
#include "ui/editors/record_part.h"
#include "ui/pages/command_parts.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

const StartupCommand& none() {
  static const StartupCommand command;
  return command;
}

/// Parsed once for each look: lists are short.
StartupCommand coeOf(const std::string& record) { return settings::parse_startup(record).value_or(none()); }
SoeCommand soeOf(const std::string& record) { return settings::parse_soe(record).value_or(SoeCommand{}); }

constexpr CommandCodec<StartupCommand> kCoe{coeOf, settings::format_startup};
constexpr CommandCodec<SoeCommand> kSoe{soeOf, settings::format_soe};

QString startupObjectText(const StartupCommand& command) { return objectText(command.index, command.sub_index); }

Status setObject(StartupCommand& command, const QString& typed) {
  const auto object = object_name(typed.trimmed().toStdString());
  if (!object || object->index == 0) {
    return settings::bad_value(
        Reason::verbatim(CommandWords::tr("\"%1\" is no object like 0x6060:00").arg(typed).toStdString()));
  }
  command.index = object->index;
  command.sub_index = object->sub_index;
  return {};
}

RecordPart valuePart(const ValueType& type) {
  return {.object_name = "coeValue",
          .label = CommandWords::tr("Value"),
          .tip = CommandWords::tr("Decimal, or hexadecimal with 0x; bytes in the order of the wire (ENI InitCmd/Data)"),
          .width = 84,
          .text = kCoe.text([type](const StartupCommand& command) {
            return QString::fromStdString(value_text(type(command), command.data));
          }),
          .put = kCoe.put([type](StartupCommand& command, const QString& typed) -> Status {
            auto bytes = value_bytes(type(command), typed.trimmed().toStdString());
            if (!bytes) return settings::bad_value(bytes.error().detail);
            command.data = std::move(*bytes);
            return {};
          })};
}

QString idnText(const SoeCommand& command) { return QString::fromStdString(soe::idn_text(command.idn)); }

Status setIdn(SoeCommand& command, const QString& typed) {
  const auto idn = settings::parse_idn(typed.trimmed().toStdString());
  if (!idn) {
    return settings::bad_value(
        Reason::verbatim(CommandWords::tr("\"%1\" is no IDN like S-0-0047").arg(typed).toStdString()));
  }
  command.idn = *idn;
  return {};
}

Status setDrive(SoeCommand& command, const QString& typed) {
  bool good = false;
  const auto drive = typed.trimmed().toUInt(&good);
  if (!good || drive > 7)
    return settings::bad_value(Reason::verbatim(CommandWords::tr("drives count from 0 to 7").toStdString()));
  command.drive = static_cast<std::uint8_t>(drive);
  return {};
}

constexpr auto kEsiHasIt = [](const auto& command, const DeviceDescription& device) {
  return is_from_esi(command, device);
};

}  // namespace

std::uint16_t usualType(const DeviceDescription& device, const StartupCommand& command) {
  if (command.complete_access) return kBytesType;
  for (const auto& object : device.dictionary) {
    if (object.index != command.index) continue;
    const auto entry = std::ranges::find(object.entries, command.sub_index, &ObjectEntry::sub_index);
    if (entry == object.entries.end()) break;
    if (const auto* type = coe::find_data_type(entry->data_type); type != nullptr && type->code != 0) return type->code;
  }
  constexpr std::uint16_t kUsint = 0x0005, kUint = 0x0006, kUdint = 0x0007;
  if (command.data.size() == 1) return kUsint;
  if (command.data.size() == 2) return kUint;
  return command.data.size() == 4 ? kUdint : kBytesType;
}

std::vector<RecordPart> coeParts(const ValueType& type, const ShownDevice& device) {
  return {togglePart(kCoe, "coeEnabled", CommandWords::tr("Enabled"),
                     CommandWords::tr("Off: the command is kept, but not sent"), 58, &StartupCommand::enabled),
          transitionPart(kCoe, "coeTransitions"),
          {.object_name = "coeObject",
           .label = CommandWords::tr("Object"),
           .tip = CommandWords::tr("Index and sub-index, hexadecimal: 0x6060:00 (ENI InitCmd/Index and SubIndex)"),
           .width = 90,
           .text = kCoe.text(startupObjectText),
           .put = kCoe.put(setObject)},
          valuePart(type),
          originPart(kCoe, "coeOrigin", device, kEsiHasIt),
          commentPart(kCoe, "coeComment"),
          timeoutPart(kCoe, "coeTimeout"),
          togglePart(
              kCoe, "coeComplete", CommandWords::tr("Complete access"),
              CommandWords::tr("The value is the whole object, from sub-index 0 or 1 on (ENI InitCmd@CompleteAccess)"),
              -1, &StartupCommand::complete_access),
          togglePart(kCoe, "coeFixed", CommandWords::tr("Fixed"),
                     CommandWords::tr("The device needs the command as it is (ENI InitCmd@Fixed)"), -1,
                     &StartupCommand::fixed),
          togglePart(kCoe, "coeAdapt", CommandWords::tr("Adapt automatically"),
                     CommandWords::tr(
                         "The value follows another setting, such as the cycle time (ESI InitCmd@AdaptAutomatically)"),
                     -1, &StartupCommand::adapt_automatically)};
}

std::vector<RecordPart> soeParts(const ShownDevice& device) {
  return {togglePart(kSoe, "soeEnabled", CommandWords::tr("Enabled"),
                     CommandWords::tr("Off: the command is kept, but not sent"), 58, &SoeCommand::enabled),
          transitionPart(kSoe, "soeTransitions"),
          {.object_name = "soeDrive",
           .label = CommandWords::tr("Drive"),
           .tip = CommandWords::tr("Drive of the device, 0 to 7 (ENI InitCmd/DriveNo)"),
           .width = 56,
           .text = kSoe.text([](const SoeCommand& command) { return QString::number(command.drive); }),
           .put = kSoe.put(setDrive)},
          {.object_name = "soeIdn",
           .label = CommandWords::tr("IDN"),
           .tip = CommandWords::tr("Standard or product parameter: S-0-0047, P-0-0100 (ENI InitCmd/IDN)"),
           .width = 90,
           .text = kSoe.text(idnText),
           .put = kSoe.put(setIdn)},
          bytesPart(kSoe, "soeValue", CommandWords::tr("Value"),
                    CommandWords::tr("Bytes in hexadecimal, in the order of the wire (ENI InitCmd/Data)"), 84,
                    &SoeCommand::data),
          originPart(kSoe, "soeOrigin", device, kEsiHasIt),
          commentPart(kSoe, "soeComment"),
          timeoutPart(kSoe, "soeTimeout"),
          togglePart(kSoe, "soeFixed", CommandWords::tr("Fixed"),
                     CommandWords::tr("The device needs the command as it is (ENI InitCmd@Fixed)"), -1,
                     &SoeCommand::fixed)};
}

}  // namespace syncline::ui
