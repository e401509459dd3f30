// SPDX-License-Identifier: Apache-2.0
#include "ui/text/overview_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>

#include "ui/text/event_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/joined_text.h"
#include "ui/text/recorded_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kMostFollowers = 5;

/// Source text for lupdate's "Overview" context.
class Overview {
  Q_DECLARE_TR_FUNCTIONS(Overview)

 public:
  static QString fault(const Fault& fault, const RunRecord& record) {
    QString text;
    if (fault.event) {
      text = briefText(*fault.event);
      if (text.isEmpty()) text = tr("An event without words");
    } else {
      text = tr("%n SM2 event(s) missed", nullptr, static_cast<int>(std::min<std::uint64_t>(fault.count, INT32_MAX)));
    }
    if (fault.event && fault.count > 1) text += tr(" (%1 times)").arg(countText(fault.count));
    return fault.slave < 0 ? text : nodeName(record.config(), fault.slave) + QStringLiteral(": ") + text;
  }

  static QString lamp(const SyncLamp& lamp, const SyncOverview& overview) {
    if (lamp.since == 0) return {};
    const auto since = tr("for %1").arg(spanText(overview.end - lamp.since));
    if (!is_watched(lamp.state) || !overview.armed) return since;
    if (!lamp.last_lost) return lamp.state == SyncState::kInSync ? since + tr(", not lost since it was armed") : since;
    return since + tr(", last lost %1 ago, %n time(s)", nullptr,
                      static_cast<int>(std::min<std::uint64_t>(lamp.times_lost, INT32_MAX)))
                       .arg(spanText(overview.end - *lamp.last_lost));
  }

  static QString link(Nanoseconds time, const QString& text) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(time).arg(text.toHtmlEscaped());
  }

  static QString nothingHappened(const QString& since, const RunRecord& record, std::span<const Finding> findings) {
    const auto span = spanText(record.overview().end - *record.overview().armed);
    const auto* worst = worstOf(findings, *record.overview().armed);
    if (worst == nullptr) return tr("<b>No fault</b> since %1 (for %2).").arg(since, span);
    return tr("<b>Nothing fell or was lost</b> since %1 (for %2), but <b>%3</b>")
        .arg(since, span, finding(*worst, record));
  }

  static QString finding(const Finding& found, const RunRecord& record) {
    auto text = findingText(found);
    if (found.place.slave >= 0) text = nodeName(record.config(), found.place.slave) + QStringLiteral(": ") + text;
    return found.from > 0 ? link(found.from, text) : text.toHtmlEscaped();
  }

  /// What arming waits for, and what is known of why it does not come.
  static QString notArmed(const RunRecord& record, std::span<const Finding> findings) {
    const auto& overview = record.overview();
    QStringList now;
    if (overview.state != AlState::kOp) now << masterStateName(overview.state);
    if (!is_ready(overview.slaves.state)) now << tr("slaves: %1").arg(syncStateText(overview.slaves.state));
    if (!is_ready(overview.master.state)) now << tr("master: %1").arg(syncStateText(overview.master.state));
    auto text = tr(
        "<b>Not armed yet:</b> figures and faults count once the machine is in OP, and in sync where that is watched.");
    QStringList sentences{text};
    if (!now.isEmpty()) sentences << tr("Now: %1.").arg(joinedClauses(now));
    if (const auto* worst = worstOf(findings, 0))
      sentences << tr("Found so far: <b>%1</b>").arg(finding(*worst, record));
    return joinedSentences(sentences);
  }

  static QString firstFault(const RunRecord& record, std::span<const Finding> findings) {
    const auto& overview = record.overview();
    if (!overview.armed) return notArmed(record, findings);
    const auto& log = overview.faults;
    const auto since = momentText(*overview.armed, record);
    if (log.episodes().empty()) return nothingHappened(since, record, findings);
    const auto& episode = log.episodes().back();
    const auto& first = episode.faults.front();
    auto text =
        tr("<b>First: %1</b> at %2.").arg(link(first.first, fault(first, record)), momentText(first.first, record));
    QStringList followers;
    for (std::size_t i = 1; i < std::min(episode.faults.size(), kMostFollowers + 1); ++i) {
      const auto& next = episode.faults[i];
      followers << tr("%1 later %2").arg(timeText(next.first - first.first), link(next.first, fault(next, record)));
    }
    if (!followers.isEmpty()) text += tr(" Then %1").arg(joinedClauses(followers));
    const auto rest = episode.faults.size() - 1 - static_cast<std::size_t>(followers.size()) + episode.left_out;
    if (rest > 0) text += tr("; %1 more").arg(countText(rest));
    if (!followers.isEmpty()) text += QLatin1Char('.');
    if (log.count() > 1) text += tr(" It is episode %1 since %2.").arg(countText(log.count()), since);
    return text;
  }

  static QString moment(Nanoseconds time, const RunRecord& record) {
    return runTimeText(time - record.overview().begin);
  }
};

}  // namespace

QString faultText(const Fault& fault, const RunRecord& record) { return Overview::fault(fault, record); }
QString lampText(const SyncLamp& lamp, const SyncOverview& overview) { return Overview::lamp(lamp, overview); }
QString firstFaultText(const RunRecord& record, std::span<const Finding> findings) {
  return Overview::firstFault(record, findings);
}
const Finding* worstOf(std::span<const Finding> findings, Nanoseconds since) {
  const Finding* worst = nullptr;
  for (const auto& finding : findings) {
    // What has no time is of the whole run, or of now.
    const auto last = std::max(finding.from, finding.to);
    if (finding.severity == Severity::kNote || (last > 0 && last < since)) continue;
    if (worst == nullptr || finding.severity > worst->severity) worst = &finding;
  }
  return worst;
}
QString momentText(Nanoseconds time, const RunRecord& record) { return Overview::moment(time, record); }

}  // namespace syncline::ui
