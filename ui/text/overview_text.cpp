// SPDX-License-Identifier: Apache-2.0
#include "ui/text/overview_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cstdlib>

#include "record/run_record.h"
#include "trace/fault_log.h"
#include "trace/sync_overview.h"
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
    const auto since = tr("for %1").arg(spanText(overview.end - lamp.of_all_since()));
    if (!is_watched(lamp.state) || !overview.armed) return since;
    const auto lost = lamp.any_lost();
    if (!lost) return lamp.state == SyncState::kInSync ? since + tr(", not lost since armed") : since;
    return since + tr(", last lost %1 ago, %n time(s)", nullptr,
                      static_cast<int>(std::min<std::uint64_t>(lamp.times_any_lost(), INT32_MAX)))
                       .arg(spanText(overview.end - *lost));
  }

  static QString link(Nanoseconds time, const QString& text) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(time).arg(text.toHtmlEscaped());
  }

  static QString nothingHappened(const QString& since, const RunRecord& record, std::span<const Finding> findings) {
    const auto span = spanText(record.overview().end - *record.overview().armed);
    const auto* worst = worstOf(findings, *record.overview().armed);
    if (worst == nullptr) return tr("<b>No fault</b> for %2, since %1 of the run.").arg(since, span);
    return tr("<b>Nothing fell or was lost</b> for %2, since %1 of the run, but <b>%3</b>")
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

  static QString firstFault(const RunRecord& record, std::span<const Finding> findings, std::size_t place) {
    const auto& overview = record.overview();
    if (!overview.armed) return notArmed(record, findings);
    const auto& log = overview.faults;
    const auto since = momentText(*overview.armed, record);
    if (log.episodes().empty()) return nothingHappened(since, record, findings);
    const auto& episode = log.episodes()[std::min(place, log.episodes().size() - 1)];
    const auto& lead = episode.faults[episode.leading()];
    auto text = leading(lead, record) + followers(episode, record);
    if (const auto others = lasting(log, lead, record); !others.isEmpty())
      text += tr(" Not over: %1.").arg(joinedClauses(others));
    if (log.count() > 1) {
      text += tr(" It is episode %1 of %2 since %3.")
                  .arg(countText(log.count() - log.episodes().size() + std::min(place, log.episodes().size() - 1) + 1),
                       countText(log.count()), since);
    }
    return text;
  }

  static QString leading(const Fault& lead, const RunRecord& record) {
    const auto what = link(lead.first, fault(lead, record));
    const auto when = momentText(lead.first, record);
    if (lead.over) return tr("<b>First: %1</b> at %2, until %3.").arg(what, when, momentText(*lead.over, record));
    if (lead.lasts()) return tr("<b>First: %1</b> at %2, and it is not over.").arg(what, when);
    return tr("<b>First: %1</b> at %2.").arg(what, when);
  }

  /// How much later, or earlier: by the cycles in which it was seen, as long as these can be counted.
  static QString distance(Nanoseconds time, const RunRecord& record) {
    constexpr Nanoseconds kCountable = 20;
    const auto cycle = record.limits().cycle_time;
    const auto size = std::abs(time);
    const auto span = [size] {
      if (size >= kSecond) return spanText(size);
      return cycleText(size < kMillisecond ? size : (size + kMillisecond / 2) / kMillisecond * kMillisecond);
    };
    const auto cycles = cycle > 0 ? static_cast<int>((size + cycle / 2) / cycle) : 0;
    if (cycle > 0 && cycles == 0) return tr("in the same cycle");
    const bool counted = cycle > 0 && size < kCountable * cycle;
    if (time < 0) return counted ? tr("%n cycle(s) before", nullptr, cycles) : tr("%1 before").arg(span());
    return counted ? tr("%n cycle(s) later", nullptr, cycles) : tr("%1 later").arg(span());
  }

  static QString followers(const FaultEpisode& episode, const RunRecord& record) {
    const auto lead = episode.leading();
    QStringList before, after;
    QString said;
    for (std::size_t i = 0; i < std::min(episode.faults.size(), kMostFollowers + 1); ++i) {
      if (i == lead) continue;
      const auto& next = episode.faults[i];
      auto& list = i < lead ? before : after;
      const auto when = distance(next.first - episode.faults[lead].first, record);
      const auto what = link(next.first, fault(next, record));
      list << (when == said ? what : tr("%1 %2", "when, what").arg(when, what));
      said = when;
    }
    QString text;
    if (!before.isEmpty()) text += tr(" Seen %1.").arg(joinedClauses(before));
    if (after.isEmpty()) return text;
    text += tr(" Then %1").arg(joinedClauses(after));
    const auto shown = static_cast<std::size_t>(before.size() + after.size());
    const auto rest = episode.faults.size() - 1 - shown + episode.left_out;
    if (rest > 0) text += tr("; %1 more").arg(countText(rest));
    return text + QLatin1Char('.');
  }

  /// What lasts, of all episodes, but the one that is told already; slaves that do not answer in one clause.
  static QStringList lasting(const FaultLog& log, const Fault& told, const RunRecord& record) {
    QStringList all;
    const Fault* silent = nullptr;
    int count = 0;
    for (const auto* fault : log.lasting()) {
      if (fault == &told) continue;
      if (fault->event->is<events::SlaveLost>()) {
        if (silent == nullptr) silent = fault;
        ++count;
      } else {
        all << link(fault->first, Overview::fault(*fault, record));
      }
    }
    if (count == 1) all << link(silent->first, fault(*silent, record));
    if (count > 1) all << link(silent->first, tr("%n slave(s) do(es) not answer", nullptr, count));
    return all;
  }

  static QString moment(Nanoseconds time, const RunRecord& record) {
    return runTimeText(time - record.overview().begin);
  }
};

}  // namespace

QString lampText(const SyncLamp& lamp, const SyncOverview& overview) { return Overview::lamp(lamp, overview); }
QString firstFaultText(const RunRecord& record, std::span<const Finding> findings, std::size_t episode) {
  return Overview::firstFault(record, findings, episode);
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
