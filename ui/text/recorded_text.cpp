// SPDX-License-Identifier: Apache-2.0
#include "ui/text/recorded_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "record/recording.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "record/typed_values.h"
#include "ui/text/event_text.h"
#include "ui/text/message.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString nameOf(const RunRecord& record, int slave) {
  if (slave < 0) return QCoreApplication::translate("Recorded", "Master");
  return QString::fromStdString(record.slave_name(static_cast<std::size_t>(slave)));
}

Severity severityOf(const std::string& name) {
  if (name == severity_name(Severity::kError)) return Severity::kError;
  return name == severity_name(Severity::kWarning) ? Severity::kWarning : Severity::kNote;
}

Message wordsOf(const RunRecord& record, Nanoseconds time, int slave, Severity severity, const std::string& text) {
  Message message{dateTimeOf(time), severity, nameOf(record, slave), QString::fromStdString(text), slave, {}};
  message.moment = time;
  message.run = kRecordedRun;
  return message;
}

/// Nothing for events that only programs care about.
std::optional<Message> messageOfRecorded(const RunRecord& record, const RecordedEvent& recorded) {
  if (auto what = decode_event(recorded.details)) {
    auto message = messageOf(Event{recorded.time, recorded.slave, std::move(*what)}, record.config());
    if (message) message->run = kRecordedRun;
    return message;
  }
  return wordsOf(record, recorded.time, recorded.slave, Severity::kNote, recorded.text);
}

std::vector<const RecordedEvent*> latestFirst(const std::vector<RecordedEvent>& events) {
  std::vector<const RecordedEvent*> result;
  result.reserve(events.size());
  for (const auto& event : events) result.push_back(&event);
  std::ranges::stable_sort(result, {}, &RecordedEvent::time);
  std::ranges::reverse(result);
  return result;
}

QString endText(const RecordingInfo& info) {
  if (!info.ended) return QCoreApplication::translate("Recorded", "cut short; whole up to its last second");
  if (*info.ended == "end of the run") return QCoreApplication::translate("Recorded", "up to the end of the run");
  if (*info.ended == "end of the file") return QCoreApplication::translate("Recorded", "up to the end of the file");
  if (*info.ended == "stopped by the user") return QCoreApplication::translate("Recorded", "stopped by the user");
  if (*info.ended == "the last stretch out of memory")
    return QCoreApplication::translate("Recorded", "the last stretch out of memory");
  return QString::fromStdString(*info.ended);
}

}  // namespace

std::vector<Message> messagesOf(const ReplayedRun& run, std::size_t most) {
  std::vector<Message> messages;
  const auto& record = *run.record;
  for (const auto* const recorded : latestFirst(run.info.events)) {
    if (messages.size() == most) break;
    if (auto message = messageOfRecorded(record, *recorded)) messages.push_back(std::move(*message));
  }
  std::ranges::reverse(messages);
  for (const auto& note : run.info.notes) {
    messages.push_back(wordsOf(record, note.time, -1, Severity::kNote, note.text));
    messages.back().source = QCoreApplication::translate("Recorded", "Note");
  }
  for (const auto& finding : run.info.findings) {
    if (decode_finding(finding.details)) continue;
    messages.push_back(wordsOf(record, run.info.end, finding.slave, severityOf(finding.level), finding.text));
  }
  std::ranges::stable_sort(messages, {}, &Message::moment);
  if (messages.size() > most) messages.erase(messages.begin(), messages.end() - static_cast<std::ptrdiff_t>(most));
  return messages;
}

QString spanText(Nanoseconds span) {
  const auto seconds = span / kSecond;
  if (seconds < 60) return QCoreApplication::translate("Recorded", "%1 s").arg(seconds);
  if (seconds < 3600) return QCoreApplication::translate("Recorded", "%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
  return QCoreApplication::translate("Recorded", "%1 h %2 min").arg(seconds / 3600).arg(seconds / 60 % 60);
}

QString recordingText(const ReplayedRun& run) {
  const auto& info = run.info;
  const auto project = std::ranges::find(info.about.documents, std::string("project"), &RecordedDocument::kind);
  const auto other = info.about.program.starts_with("import of")
                         ? QCoreApplication::translate("Recorded", "an imported run")
                         : QCoreApplication::translate("Recorded", "a machine");
  const auto name = project == info.about.documents.end() ? other : QString::fromStdString(project->name);
  auto text =
      QCoreApplication::translate("Recorded", "%1 on %2, %3, %4 in %5 cycles of %6, %7")
          .arg(name, QString::fromStdString(info.about.link),
               QLocale().toString(dateTimeOf(info.begin), QLocale::ShortFormat), spanText(info.end - info.begin),
               countText(info.cycles), cycleText(info.about.limits.cycle_time), endText(info));
  if (info.missing_cycles > 0) {
    text +=
        QCoreApplication::translate("Recorded", "; %1 cycles are missing in it").arg(countText(info.missing_cycles));
  }
  if (info.cycles > ReplayOptions::kMostCycles) {
    text += QCoreApplication::translate("Recorded", "; the plots show the last %1 of them")
                .arg(countText(ReplayOptions::kMostCycles));
  }
  return text;
}

}  // namespace syncline::ui
