// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/startup_parts.h"

#include <QCoreApplication>
#include <algorithm>

#include "config/device_description.h"
#include "protocol/coe_data_type.h"
#include "protocol/object_value.h"
#include "settings/startup_text.h"
#include "ui/editors/record_part.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

using Kind = RecordPart::Kind;

/// Words of the page.
class Words {
  Q_DECLARE_TR_FUNCTIONS(SlaveStartupPage)
};

const StartupCommand& none() {
  static const StartupCommand command;
  return command;
}

/// Parsed once for each look: lists are short.
StartupCommand coeOf(const std::string& record) { return settings::parse_startup(record).value_or(none()); }
SoeCommand soeOf(const std::string& record) { return settings::parse_soe(record).value_or(SoeCommand{}); }

/// The columns and fields of a command of either kind.
template <class Command>
struct Codec {
  Command (*parse)(const std::string&);
  std::string (*format)(const Command&);

  template <class Read>
  auto text(Read read) const {
    return [*this, read](const Records& records, std::size_t row) -> QString { return read(parse(records[row])); };
  }
  template <class Change>
  auto put(Change change) const {
    return [*this, change](const std::string& record, const QString& typed) -> Result<std::string> {
      auto command = parse(record);
      if (auto status = change(command, typed); !status) return tl::unexpected(status.error());
      return format(command);
    };
  }
};
constexpr Codec<StartupCommand> kCoe{coeOf, settings::format_startup};
constexpr Codec<SoeCommand> kSoe{soeOf, settings::format_soe};

QString flag(bool on) { return on ? QStringLiteral("on") : QString(); }

template <class Command>
RecordPart toggle(const Codec<Command>& codec, const char* name, const QString& label, const QString& tip, int width,
                  bool Command::*part) {
  return {.object_name = name,
          .label = label,
          .tip = tip,
          .kind = Kind::kToggle,
          .width = width,
          .text = codec.text([part](const Command& command) { return flag(command.*part); }),
          .put = codec.put([part](Command& command, const QString& typed) -> Status {
            command.*part = !typed.isEmpty();
            return {};
          })};
}

QList<std::pair<QString, QString>> transitions() {
  QList<std::pair<QString, QString>> all;
  constexpr std::pair<const char*, const char*> kKnown[] = {
      {"IP", QT_TRANSLATE_NOOP("SlaveStartupPage", "INIT to PREOP")},
      {"PS", QT_TRANSLATE_NOOP("SlaveStartupPage", "PREOP to SAFEOP")},
      {"SO", QT_TRANSLATE_NOOP("SlaveStartupPage", "SAFEOP to OP")},
      {"IB", QT_TRANSLATE_NOOP("SlaveStartupPage", "INIT to BOOT")},
      {"PP", QT_TRANSLATE_NOOP("SlaveStartupPage", "PREOP again")},
      {"OS", QT_TRANSLATE_NOOP("SlaveStartupPage", "OP to SAFEOP")},
      {"OP", QT_TRANSLATE_NOOP("SlaveStartupPage", "OP to PREOP")},
      {"SP", QT_TRANSLATE_NOOP("SlaveStartupPage", "SAFEOP to PREOP")},
      {"SI", QT_TRANSLATE_NOOP("SlaveStartupPage", "SAFEOP to INIT")},
      {"PI", QT_TRANSLATE_NOOP("SlaveStartupPage", "PREOP to INIT")}};
  for (const auto& [word, text] : kKnown) all.append({QLatin1String(word), Words::tr(text)});
  return all;
}

template <class Command>
RecordPart transitionPart(const Codec<Command>& codec, const char* name) {
  return {.object_name = name,
          .label = Words::tr("Transitions"),
          .tip = Words::tr("State changes at which the command is sent (ENI InitCmd/Transition)"),
          .kind = Kind::kSet,
          .width = 78,
          .text = codec.text([](const Command& command) {
            return QString::fromStdString(settings::format_transitions(command.transitions));
          }),
          .put = codec.put([](Command& command, const QString& typed) -> Status {
            return settings::parse_transitions(typed.toStdString(), command.transitions);
          }),
          .options = transitions};
}

template <class Command>
RecordPart timeoutPart(const Codec<Command>& codec, const char* name) {
  return {
      .object_name = name,
      .label = Words::tr("Time-out"),
      .tip = Words::tr("ms for the answer; empty: the master's own (ENI InitCmd/Timeout)"),
      .width = -1,
      .text = codec.text([](const Command& command) {
        return command.timeout_ms == 0 ? QString() : QString::number(command.timeout_ms);
      }),
      .put = codec.put([](Command& command, const QString& typed) -> Status {
        bool good = true;
        const auto ms = typed.trimmed().isEmpty() ? 0U : typed.trimmed().toUInt(&good);
        if (!good)
          return settings::bad_value(Reason::verbatim(Words::tr("a time-out is a whole number of ms").toStdString()));
        command.timeout_ms = ms;
        return {};
      })};
}

template <class Command>
RecordPart commentPart(const Codec<Command>& codec, const char* name) {
  return {.object_name = name,
          .label = Words::tr("Comment"),
          .tip = Words::tr("Beside the command in the ENI (InitCmd/Comment)"),
          .width = 0,
          .text = codec.text([](const Command& command) { return QString::fromStdString(command.comment); }),
          .put = codec.put([](Command& command, const QString& typed) -> Status {
            command.comment = typed.simplified().toStdString();
            return {};
          })};
}

QString startupObjectText(const StartupCommand& command) {
  return QStringLiteral("%1:%2").arg(hexText(command.index, 4), hexText(command.sub_index, 2).mid(2));
}

Status setObject(StartupCommand& command, const QString& typed) {
  const auto object = object_name(typed.trimmed().toStdString());
  if (!object || object->index == 0) {
    return settings::bad_value(
        Reason::verbatim(Words::tr("\"%1\" is no object like 0x6060:00").arg(typed).toStdString()));
  }
  command.index = object->index;
  command.sub_index = object->sub_index;
  return {};
}

RecordPart valuePart(const ValueType& type) {
  return {.object_name = "coeValue",
          .label = Words::tr("Value"),
          .tip = Words::tr("Decimal, or hexadecimal with 0x; bytes in the order of the wire (ENI InitCmd/Data)"),
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

/// "S-0-0047" of "PS 0:S-0-0047=0a00".
QString idnText(const SoeCommand& command) {
  const auto text = QString::fromStdString(settings::format_soe(command));
  return text.section(u':', 1).section(u'=', 0, 0);
}

Status setIdn(SoeCommand& command, const QString& typed) {
  auto text = QString::fromStdString(settings::format_soe(command));
  text.replace(u':' + idnText(command) + u'=', u':' + typed.trimmed() + u'=');
  auto changed = settings::parse_soe(text.toStdString());
  if (!changed)
    return settings::bad_value(Reason::verbatim(Words::tr("\"%1\" is no IDN like S-0-0047").arg(typed).toStdString()));
  command.idn = changed->idn;
  return {};
}

Status setDrive(SoeCommand& command, const QString& typed) {
  bool good = false;
  const auto drive = typed.trimmed().toUInt(&good);
  if (!good || drive > 7)
    return settings::bad_value(Reason::verbatim(Words::tr("drives count from 0 to 7").toStdString()));
  command.drive = static_cast<std::uint8_t>(drive);
  return {};
}

Status setBytes(SoeCommand& command, const QString& typed) {
  auto bytes = settings::parse_hex_data(typed.simplified().remove(u' ').toStdString());
  if (!bytes) return settings::bad_value(bytes.error().detail);
  command.data = std::move(*bytes);
  return {};
}

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

std::vector<RecordPart> coeParts(const ValueType& type) {
  return {
      toggle(kCoe, "coeEnabled", Words::tr("Enabled"), Words::tr("Off: the command is kept, but not sent"), 58,
             &StartupCommand::enabled),
      transitionPart(kCoe, "coeTransitions"),
      {.object_name = "coeObject",
       .label = Words::tr("Object"),
       .tip = Words::tr("Index and sub-index, hexadecimal: 0x6060:00 (ENI InitCmd/Index and SubIndex)"),
       .width = 90,
       .text = kCoe.text(startupObjectText),
       .put = kCoe.put(setObject)},
      valuePart(type),
      commentPart(kCoe, "coeComment"),
      timeoutPart(kCoe, "coeTimeout"),
      toggle(kCoe, "coeComplete", Words::tr("Complete access"),
             Words::tr("The value is the whole object, from sub-index 0 or 1 on (ENI InitCmd@CompleteAccess)"), -1,
             &StartupCommand::complete_access),
      toggle(kCoe, "coeFixed", Words::tr("Fixed"),
             Words::tr("The device needs the command as it is (ENI InitCmd@Fixed)"), -1, &StartupCommand::fixed),
      toggle(kCoe, "coeAdapt", Words::tr("Adapt automatically"),
             Words::tr("The value follows another setting, such as the cycle time (ESI InitCmd@AdaptAutomatically)"),
             -1, &StartupCommand::adapt_automatically)};
}

std::vector<RecordPart> soeParts() {
  return {toggle(kSoe, "soeEnabled", Words::tr("Enabled"), Words::tr("Off: the command is kept, but not sent"), 58,
                 &SoeCommand::enabled),
          transitionPart(kSoe, "soeTransitions"),
          {.object_name = "soeDrive",
           .label = Words::tr("Drive"),
           .tip = Words::tr("Drive of the device, 0 to 7 (ENI InitCmd/DriveNo)"),
           .width = 56,
           .text = kSoe.text([](const SoeCommand& command) { return QString::number(command.drive); }),
           .put = kSoe.put(setDrive)},
          {.object_name = "soeIdn",
           .label = Words::tr("IDN"),
           .tip = Words::tr("Standard or product parameter: S-0-0047, P-0-0100 (ENI InitCmd/IDN)"),
           .width = 90,
           .text = kSoe.text(idnText),
           .put = kSoe.put(setIdn)},
          {.object_name = "soeValue",
           .label = Words::tr("Value"),
           .tip = Words::tr("Bytes in hexadecimal, in the order of the wire (ENI InitCmd/Data)"),
           .width = 84,
           .text = kSoe.text(
               [](const SoeCommand& command) { return QString::fromStdString(value_text(kBytesType, command.data)); }),
           .put = kSoe.put(setBytes)},
          commentPart(kSoe, "soeComment"),
          timeoutPart(kSoe, "soeTimeout"),
          toggle(kSoe, "soeFixed", Words::tr("Fixed"),
                 Words::tr("The device needs the command as it is (ENI InitCmd@Fixed)"), -1, &SoeCommand::fixed)};
}

}  // namespace syncline::ui
