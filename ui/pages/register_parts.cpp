// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/register_command.h"
#include "settings/command_words.h"
#include "settings/message_text.h"
#include "ui/pages/message_parts.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

RegisterCommand registerOf(const std::string& record) {
  return settings::parse_register(record).value_or(RegisterCommand{});
}
constexpr CommandCodec<RegisterCommand> kRegister{registerOf, settings::format_register};

struct RegisterNames {
  const char *enabled, *transitions, *direction, *address, *data, *expected, *mask, *within, *after, *comment;
};
constexpr RegisterNames kRegisterOfSlave{"registerEnabled", "registerTransitions", "registerDirection",
                                         "registerAddress", "registerData",        "registerExpected",
                                         "registerMask",    "registerWithin",      "",
                                         "registerComment"};
constexpr RegisterNames kRegisterOfMaster{
    "masterRegisterEnabled", "masterRegisterTransitions", "masterRegisterDirection", "masterRegisterAddress",
    "masterRegisterData",    "masterRegisterExpected",    "masterRegisterMask",      "masterRegisterWithin",
    "masterRegisterAfter",   "masterRegisterComment"};

Status refusedRegister(const QString& why) { return settings::bad_value(Reason::verbatim(why.toStdString())); }

/// A part that stands for itself is checkedRegister with the others as the text form of the whole.
Status checkedRegister(const RegisterCommand& command) {
  const auto parsed = settings::parse_register(settings::format_register(command));
  if (!parsed) return settings::bad_value(parsed.error().detail);
  return {};
}

/// What is compared is as long as what is read.
void fitExpected(RegisterCommand& command) {
  constexpr std::uint8_t kAllBits = 0xFF;
  const auto size = command.read ? command.data.size() : 0;
  if (!command.expected.empty()) command.expected.resize(size);
  if (!command.mask.empty()) command.mask.resize(size, kAllBits);
}

QList<std::pair<QString, QString>> registerDirections() {
  return {{QStringLiteral("write"), CommandWords::tr("Write")}, {QStringLiteral("read"), CommandWords::tr("Read")}};
}

Status setRegisterDirection(RegisterCommand& command, const QString& word) {
  command.read = word == QLatin1String("read");
  std::ranges::fill(command.data, std::uint8_t{0});
  fitExpected(command);
  return {};
}

Status setRegisterAddress(RegisterCommand& command, const QString& typed) {
  bool good = false;
  const auto address = typed.trimmed().toUInt(&good, 0);
  if (!good || address > 0xFFFF)
    return refusedRegister(CommandWords::tr("\"%1\" is no register like 0x09A8").arg(typed));
  command.address = static_cast<std::uint16_t>(address);
  return checkedRegister(command);
}

/// Bytes of a write; of a read how many there are.
QString registerDataText(const RegisterCommand& command) {
  return command.read ? QString::number(command.data.size()) : bytesText(command.data);
}

Status setRegisterData(RegisterCommand& command, const QString& typed) {
  if (command.read) {
    bool good = false;
    const auto length = typed.trimmed().toUInt(&good);
    constexpr unsigned kMost = 1486;
    if (!good || length < 1 || length > kMost)
      return refusedRegister(CommandWords::tr("a read takes 1 to %1 bytes").arg(kMost));
    command.data.assign(length, 0);
    fitExpected(command);
    return checkedRegister(command);
  }
  auto bytes = settings::parse_hex_data(typed.simplified().remove(u' ').toStdString());
  if (!bytes) return settings::bad_value(bytes.error().detail);
  if (bytes->empty()) return refusedRegister(CommandWords::tr("a write has at least one byte"));
  command.data = std::move(*bytes);
  return checkedRegister(command);
}

/// Expected value or mask; nothing takes it away, and the mask with the value.
RecordPart comparedPart(const char* name, const QString& label, const QString& tip, int width,
                        std::vector<std::uint8_t> RegisterCommand::*part) {
  auto compared = bytesPart(kRegister, name, label, tip, width, part);
  compared.put = kRegister.put([part](RegisterCommand& command, const QString& typed) -> Status {
    auto bytes = settings::parse_hex_data(typed.simplified().remove(u' ').toStdString());
    if (!bytes) return settings::bad_value(bytes.error().detail);
    command.*part = std::move(*bytes);
    if (command.expected.empty()) command.mask.clear();
    return checkedRegister(command);
  });
  return compared;
}

RecordPart withinPart(const char* name) {
  return {.object_name = name,
          .label = CommandWords::tr("Within"),
          .tip = CommandWords::tr("ms for the expected value to come (ENI Validate/Timeout)"),
          .width = -1,
          .text = kRegister.text([](const RegisterCommand& command) { return QString::number(command.timeout_ms); }),
          .put = kRegister.put([](RegisterCommand& command, const QString& typed) -> Status {
            bool good = false;
            const auto ms = typed.trimmed().toUInt(&good);
            if (!good) return refusedRegister(CommandWords::tr("a time-out is a whole number of ms"));
            command.timeout_ms = ms;
            return {};
          })};
}

RecordPart directionPart(const char* name) {
  return {
      .object_name = name,
      .label = CommandWords::tr("Direction"),
      .tip = CommandWords::tr("Written or read; of a slave by its station address, of the master to all slaves (ENI "
                              "InitCmd/Cmd)"),
      .kind = RecordPart::Kind::kChoice,
      .width = 72,
      .text = kRegister.text(
          [](const RegisterCommand& command) { return QString::fromLatin1(command.read ? "read" : "write"); }),
      .put = kRegister.put(setRegisterDirection),
      .options = registerDirections};
}

}  // namespace

std::vector<RecordPart> registerParts(bool of_master) {
  const auto& names = of_master ? kRegisterOfMaster : kRegisterOfSlave;
  std::vector<RecordPart> parts{
      togglePart(kRegister, names.enabled, CommandWords::tr("Enabled"),
                 CommandWords::tr("Off: the command stays in the project and is not in the ENI"), 58,
                 &RegisterCommand::enabled),
      transitionPart(kRegister, names.transitions),
      directionPart(names.direction),
      {.object_name = names.address,
       .label = CommandWords::tr("Register"),
       .tip = CommandWords::tr("Byte address in the ESC: 0x09A8 (ENI InitCmd/Ado)"),
       .width = 76,
       .text = kRegister.text([](const RegisterCommand& command) { return hexText(command.address, 4); }),
       .put = kRegister.put(setRegisterAddress)},
      {.object_name = names.data,
       .label = CommandWords::tr("Data"),
       .tip = CommandWords::tr("Write: bytes in hexadecimal, in the order of the wire; read: how many bytes (ENI "
                               "InitCmd/Data)"),
       .width = 96,
       .text = kRegister.text(registerDataText),
       .put = kRegister.put(setRegisterData)},
      comparedPart(names.expected, CommandWords::tr("Expected"),
                   CommandWords::tr("What a read has to bring, in hexadecimal; empty: anything (ENI Validate/Data)"),
                   84, &RegisterCommand::expected),
      comparedPart(names.mask, CommandWords::tr("Mask"),
                   CommandWords::tr("Bits of the expected value that count, in hexadecimal; empty: all (ENI "
                                    "Validate/DataMask)"),
                   -1, &RegisterCommand::mask),
      withinPart(names.within),
      commentPart(kRegister, names.comment)};
  if (of_master) {
    parts.push_back(togglePart(kRegister, names.after, CommandWords::tr("After the slaves"),
                               CommandWords::tr("Behind the slaves' commands of the transition instead of before them "
                                                "(ENI InitCmd/BeforeSlave)"),
                               -1, &RegisterCommand::after_slaves));
  }
  return parts;
}

}  // namespace syncline::ui
