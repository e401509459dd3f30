// SPDX-License-Identifier: Apache-2.0
#include "ui/text/acceptance_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "findings/acceptance_words.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

using reports::Criterion;
using reports::Verdict;
using Kind = Criterion::Kind;

struct AcceptanceText {
  Q_DECLARE_TR_FUNCTIONS(AcceptanceText)
};

QString syncText(const Criterion& criterion) {
  if (criterion.verdict == Verdict::kNotJudged) return syncStateText(SyncState::kNotMonitored);
  auto text = AcceptanceText::tr("%1 for %2").arg(syncStateText(criterion.state), runTimeText(criterion.state_for));
  if (criterion.times_lost > 0)
    text += AcceptanceText::tr(", lost %n time(s)", nullptr, static_cast<int>(criterion.times_lost));
  if (!criterion.margin) return text + AcceptanceText::tr("; no value since it was armed");
  const auto largest = QLocale().toString(static_cast<qlonglong>(*criterion.found));
  text += criterion.kind == Kind::kMasterInSync ? AcceptanceText::tr("; largest that lasted %1 ns").arg(largest)
                                                : AcceptanceText::tr("; largest %1 ns").arg(largest);
  return text + (*criterion.margin < 0
                     ? AcceptanceText::tr(", over the limit")
                     : AcceptanceText::tr(", %1 % margin").arg(static_cast<int>(std::floor(*criterion.margin * 100))));
}

}  // namespace

QString criterionText(Kind kind) { return phraseText(reports::criterion_text(kind)); }
QString verdictText(Verdict verdict) { return phraseText(reports::verdict_text(verdict)); }

QString acceptanceText(Verdict verdict) {
  switch (verdict) {
    case Verdict::kKept:
      return AcceptanceText::tr("Accepted");
    case Verdict::kNotKept:
      return AcceptanceText::tr("Not accepted");
    case Verdict::kNotJudged:
      return AcceptanceText::tr("Not proven");
  }
  return {};
}

QString requiredText(const Criterion& criterion) {
  switch (criterion.kind) {
    case Kind::kWatchedFor:
      return criterion.required <= 0 ? phraseText(words::kAsLongAsItWas) : runTimeText(criterion.required);
    case Kind::kState:
      return phraseText(words::kOpAtTheEnd);
    case Kind::kSlavesInSync:
    case Kind::kMasterInSync: {
      if (criterion.required <= 0) return phraseText(words::kInSyncThroughout);
      auto text = AcceptanceText::tr("in sync throughout, within ±%1 ns")
                      .arg(QLocale().toString(static_cast<qlonglong>(criterion.required)));
      if (criterion.least_margin > 0)
        text += AcceptanceText::tr(", %1 % to spare").arg(static_cast<int>(std::lround(criterion.least_margin * 100)));
      return text;
    }
    case Kind::kFindings:
      return phraseText(words::kNoErrorNoWarning);
    default:
      return criterion.required == 0
                 ? AcceptanceText::tr("none")
                 : AcceptanceText::tr("%1 at most").arg(QLocale().toString(static_cast<qlonglong>(criterion.required)));
  }
}

QString foundText(const Criterion& criterion) {
  const auto number = [&] { return QLocale().toString(static_cast<qlonglong>(*criterion.found)); };
  switch (criterion.kind) {
    case Kind::kWatchedFor:
      return criterion.found ? runTimeText(*criterion.found) : phraseText(words::kNeverInSync);
    case Kind::kState: {
      const auto state = static_cast<AlState>(*criterion.found);
      if (state == AlState::kNone) return phraseText(words::kStateUnknown);
      return stateName(state);
    }
    case Kind::kSlavesInSync:
    case Kind::kMasterInSync:
      return syncText(criterion);
    case Kind::kFaults:
      if (!criterion.found) return phraseText(words::kNeverArmed);
      return *criterion.found == 0 ? AcceptanceText::tr("none")
                                   : AcceptanceText::tr("%n episode(s)", nullptr, static_cast<int>(*criterion.found));
    case Kind::kFindings:
      if (criterion.verdict == Verdict::kKept) return AcceptanceText::tr("none");
      return AcceptanceText::tr("%n error(s)", nullptr, static_cast<int>(*criterion.found)) + QStringLiteral(", ") +
             AcceptanceText::tr("%n warning(s)", nullptr, static_cast<int>(criterion.warnings));
    case Kind::kMissedEvents:
      return criterion.found ? number() : phraseText(words::kNoCounterKnown);
    default:
      return criterion.found ? number() : phraseText(words::kNotTold);
  }
}

}  // namespace syncline::ui
