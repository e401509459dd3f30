// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QList>
#include <QString>
#include <functional>
#include <string>
#include <utility>

#include "config/command_text.h"
#include "settings/command_words.h"
#include "settings/setting_type.h"
#include "ui/editors/record_part.h"

namespace syncline {
struct DeviceDescription;
}  // namespace syncline

/// What the lists of start-up commands have in common: how a record is read and written part by part, and the parts
/// that all of them have.
namespace syncline::ui {

/// Words of these lists, with those of the page Start-up.
class CommandWords {
  Q_DECLARE_TR_FUNCTIONS(SlaveStartupPage)
};

/// The device of the slave that is shown; nullptr where none is.
using ShownDevice = std::function<const DeviceDescription*()>;

/// The columns and fields of a command of one kind, whose text forms `parse` and `format` know.
template <class Command>
struct CommandCodec {
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
/// State transitions, word and text for people.
[[nodiscard]] QList<std::pair<QString, QString>> transitionOptions();

template <class Command>
RecordPart togglePart(const CommandCodec<Command>& codec, const char* name, const QString& label, const QString& tip,
                      int width, bool Command::*part) {
  return {
      .object_name = name,
      .label = label,
      .tip = tip,
      .kind = RecordPart::Kind::kToggle,
      .width = width,
      .text = codec.text([part](const Command& command) { return command.*part ? QStringLiteral("on") : QString(); }),
      .put = codec.put([part](Command& command, const QString& typed) -> Status {
        command.*part = !typed.isEmpty();
        return {};
      })};
}

template <class Command>
RecordPart transitionPart(const CommandCodec<Command>& codec, const char* name) {
  return {.object_name = name,
          .label = CommandWords::tr("Transitions"),
          .tip = CommandWords::tr("State changes at which the command is sent (ENI InitCmd/Transition)"),
          .kind = RecordPart::Kind::kSet,
          .width = 78,
          .text = codec.text(
              [](const Command& command) { return QString::fromStdString(transitions_text(command.transitions)); }),
          .put = codec.put([](Command& command, const QString& typed) -> Status {
            return settings::parse_transitions(typed.toStdString(), command.transitions);
          }),
          .options = transitionOptions};
}

template <class Command>
RecordPart timeoutPart(const CommandCodec<Command>& codec, const char* name) {
  return {.object_name = name,
          .label = CommandWords::tr("Time-out"),
          .tip = CommandWords::tr("ms for the answer; empty: the master's own (ENI InitCmd/Timeout)"),
          .width = -1,
          .text = codec.text([](const Command& command) {
            return command.timeout_ms == 0 ? QString() : QString::number(command.timeout_ms);
          }),
          .put = codec.put([](Command& command, const QString& typed) -> Status {
            bool good = true;
            const auto ms = typed.trimmed().isEmpty() ? 0U : typed.trimmed().toUInt(&good);
            if (!good)
              return settings::bad_value(
                  Reason::verbatim(CommandWords::tr("a time-out is a whole number of ms").toStdString()));
            command.timeout_ms = ms;
            return {};
          })};
}

template <class Command>
RecordPart commentPart(const CommandCodec<Command>& codec, const char* name) {
  return {.object_name = name,
          .label = CommandWords::tr("Comment"),
          .tip = CommandWords::tr("Beside the command in the ENI (InitCmd/Comment)"),
          .width = 0,
          .text = codec.text([](const Command& command) { return QString::fromStdString(command.comment); }),
          .put = codec.put([](Command& command, const QString& typed) -> Status {
            command.comment = typed.simplified().toStdString();
            return {};
          })};
}

/// "08 00".
[[nodiscard]] QString bytesText(const std::vector<std::uint8_t>& bytes);

/// Who brought the command: a column without a field. `from_esi(command, device)`.
template <class Command, class FromEsi>
RecordPart originPart(const CommandCodec<Command>& codec, const char* name, const ShownDevice& device,
                      FromEsi from_esi) {
  return {.object_name = name,
          .label = CommandWords::tr("Origin"),
          .tip = CommandWords::tr("ESI: as the device's description has it; own: added or changed here"),
          .kind = RecordPart::Kind::kShown,
          .width = 56,
          .text = codec.text([device, from_esi](const Command& command) {
            const auto* of = device();
            return of != nullptr && from_esi(command, *of) ? CommandWords::tr("ESI") : CommandWords::tr("own");
          })};
}

/// The value as bytes in hexadecimal.
template <class Command>
RecordPart bytesPart(const CommandCodec<Command>& codec, const char* name, const QString& label, const QString& tip,
                     int width, std::vector<std::uint8_t> Command::*part) {
  return {.object_name = name,
          .label = label,
          .tip = tip,
          .width = width,
          .text = codec.text([part](const Command& command) { return bytesText(command.*part); }),
          .put = codec.put([part](Command& command, const QString& typed) -> Status {
            auto bytes = settings::parse_hex_data(typed.simplified().remove(u' ').toStdString());
            if (!bytes) return settings::bad_value(bytes.error().detail);
            command.*part = std::move(*bytes);
            return {};
          })};
}

}  // namespace syncline::ui
