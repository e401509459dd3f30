// SPDX-License-Identifier: Apache-2.0
#include "ui/text/quality_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "ui/text/joined_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString ofQuality(const char* text) { return QCoreApplication::translate("SignalQuality", text); }

QString clockWords(SignalInfo::Clock clock) {
  switch (clock) {
    case SignalInfo::Clock::kNone:
      break;
    case SignalInfo::Clock::kHost:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "by the host's clock"));
    case SignalInfo::Clock::kSlaves:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "by the clocks of the slaves"));
    case SignalInfo::Clock::kBoth:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "by the reference clock and the host's clock"));
  }
  return {};
}

QString stampWords(StampSource source) {
  switch (source) {
    case StampSource::kUntold:
      break;
    case StampSource::kSoftware:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "moment stamped by the master's software"));
    case StampSource::kKernel:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "moment stamped by the kernel"));
    case StampSource::kAdapter:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "moment stamped by the network card"));
    case StampSource::kCapture:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "moment stamped by the host that captured the frames"));
    case StampSource::kProbe:
      return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "moment stamped by a probe, in hardware"));
  }
  return ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "nobody tells who stamped the moment"));
}

QString rateText(double rate) { return QLocale().toString(rate, 'f', rate < 10 ? 1 : 0); }

}  // namespace

QString qualityText(const SignalQuality& quality) {
  QStringList clauses;
  if (quality.rate)
    clauses << ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "%1 readings a second")).arg(rateText(*quality.rate));
  if (quality.age)
    clauses << ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "the newest is %1 old")).arg(timeText(*quality.age));
  if (auto clock = clockWords(quality.clock); !clock.isEmpty()) {
    clauses << (quality.value_doubt ? QStringLiteral("%1 \u00B1%2").arg(clock, timeText(*quality.value_doubt)) : clock);
  }
  const auto stamp = stampWords(quality.stamped_by);
  clauses
      << (quality.time_doubt
              ? ofQuality(QT_TRANSLATE_NOOP("SignalQuality", "%1, within %2")).arg(stamp, timeText(*quality.time_doubt))
              : stamp);
  return joinedClauses(clauses);
}

}  // namespace syncline::ui
