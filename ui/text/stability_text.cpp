// SPDX-License-Identifier: Apache-2.0
#include "ui/text/stability_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>

#include "trace/even_samples.h"
#include "trace/signal_study.h"
#include "trace/spectrum.h"
#include "ui/text/joined_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString say(const char* text) { return QCoreApplication::translate("StabilityText", text); }

/// With a real minus and always with a sign.
QString slopeText(double slope) {
  const auto number = QLocale().toString(std::abs(slope), 'f', 1);
  return (slope < 0 ? QStringLiteral("\u2212") : QStringLiteral("+")) + number;
}

bool isConstant(const SignalStudy& study) {
  return !study.points.empty() && std::ranges::all_of(study.points, [](const auto& point) { return point.mtie == 0; });
}

QString gapText(std::size_t gaps) {
  if (gaps == 0) return say(QT_TRANSLATE_NOOP("StabilityText", "no gap"));
  const int count = static_cast<int>(gaps);
  return QCoreApplication::translate("StabilityText", "%n gap(s)", nullptr, count);
}

}  // namespace

QString verdictText(const SignalStudy& study, Quantity quantity) {
  if (study.given == 0) return say(QT_TRANSLATE_NOOP("StabilityText", "No samples in this range."));
  if (study.used == 0) {
    return say(QT_TRANSLATE_NOOP("StabilityText", "No even samples: between two gaps there are never as many as %1."))
        .arg(EvenSamples::kShortest);
  }
  if (isConstant(study)) return say(QT_TRANSLATE_NOOP("StabilityText", "Constant: nothing moves."));
  const auto& reading = study.reading;
  QStringList said;
  if (reading.jitter) {
    said << say(QT_TRANSLATE_NOOP("StabilityText",
                                  "Jitter at short times: ADEV falls with slope %1, neighbouring values have little to "
                                  "do with each other."))
                .arg(slopeText(*reading.short_slope));
  }
  if (reading.hunting_period > 0) {
    said << say(QT_TRANSLATE_NOOP("StabilityText", "Hunting: it swings, with a period of about %1."))
                .arg(quantityText(Quantity::kSeconds, reading.hunting_period));
  }
  if (reading.disturbed_for > 0) {
    said << say(QT_TRANSLATE_NOOP("StabilityText", "One disturbance: nearly all that moves does so within %1."))
                .arg(quantityText(Quantity::kSeconds, reading.disturbed_for));
  }
  if (reading.drift) {
    said << say(QT_TRANSLATE_NOOP(
                    "StabilityText",
                    "Drift at long times: ADEV rises with slope %1 up to the end, nothing takes it back."))
                .arg(slopeText(*reading.long_slope));
  }
  if (reading.runs_away > 0) {
    said << say(QT_TRANSLATE_NOOP("StabilityText", "It moves away by about %1 in each second."))
                .arg(quantityText(quantity, reading.runs_away));
  }
  if (!said.isEmpty()) return joinedSentences(said);
  if (!reading.short_slope) return say(QT_TRANSLATE_NOOP("StabilityText", "Too few samples for a verdict."));
  return say(QT_TRANSLATE_NOOP(
                 "StabilityText",
                 "Neither jitter, hunting nor drift stands out: slope of ADEV %1 at short times, %2 at long ones."))
      .arg(slopeText(*reading.short_slope), slopeText(*reading.long_slope));
}

QString sampleText(const SignalStudy& study) {
  QStringList said;
  const auto every = quantityText(Quantity::kSeconds, study.interval);
  if (study.used == study.given) {
    said << say(QT_TRANSLATE_NOOP("StabilityText", "%1 samples, one each %2")).arg(countText(study.used), every);
  } else {
    said << say(QT_TRANSLATE_NOOP("StabilityText", "%1 of %2 samples, one each %3"))
                .arg(countText(study.used), countText(study.given), every);
  }
  said << gapText(study.gaps);
  if (study.uneven > 0) {
    said << say(QT_TRANSLATE_NOOP("StabilityText", "%1 of them at a distance that is off by more than a tenth"))
                .arg(countText(study.uneven));
  }
  return joinedParts(said);
}

QString tauText(const SignalStudy& study) {
  if (study.points.empty()) return {};
  return say(QT_TRANSLATE_NOOP("StabilityText", "\u03C4 %1 to %2"))
      .arg(quantityText(Quantity::kSeconds, study.points.front().tau),
           quantityText(Quantity::kSeconds, study.points.back().tau));
}

QString limitText(const SignalStudy& study, double bound, const QString& limit) {
  if (study.points.empty()) return {};
  const auto most = quantityText(Quantity::kNanoseconds, bound);
  const auto above = std::ranges::find_if(study.points, [&](const auto& point) { return point.mtie > bound; });
  if (above != study.points.end()) {
    return say(QT_TRANSLATE_NOOP("StabilityText",
                                 "Beyond the limit: MTIE is above %1 for times from %2 on, so values were beyond %3."))
        .arg(most, quantityText(Quantity::kSeconds, above->tau), limit);
  }
  return say(QT_TRANSLATE_NOOP("StabilityText", "MTIE keeps the limit: it reaches %1 of %2."))
      .arg(quantityText(Quantity::kNanoseconds, study.points.back().mtie), most);
}

QString causeText(const SpectrumLine& line, std::span<const KnownFrequency> known, const SignalStudy& study) {
  using Kind = KnownFrequency::Kind;
  const double rate = study.interval > 0 ? 1 / study.interval : 0;
  const auto* cause = likely_cause(line, known, rate, study.spectrum.step);
  if (cause == nullptr) return {};
  const auto frequency = quantityText(Quantity::kHertz, cause->frequency);
  QString text;
  switch (cause->kind) {
    case Kind::kBeat:
      text = say(QT_TRANSLATE_NOOP("StabilityText", "beat of the two clocks"));
      break;
    case Kind::kTask:
      text = say(QT_TRANSLATE_NOOP("StabilityText", "task, %1")).arg(frequency);
      break;
    case Kind::kMains:
      text = say(QT_TRANSLATE_NOOP("StabilityText", "mains, %1")).arg(frequency);
      break;
    case Kind::kLoop:
      text = say(QT_TRANSLATE_NOOP("StabilityText", "swing of the DCM loop"));
      break;
  }
  if (cause->frequency > rate / 2) text += QStringLiteral(", ") + say(QT_TRANSLATE_NOOP("StabilityText", "folded"));
  return text;
}

}  // namespace syncline::ui
