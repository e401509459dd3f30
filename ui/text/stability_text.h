// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>

#include "ui/text/quantity_text.h"

namespace syncline {
struct KnownFrequency;
struct SignalStudy;
struct SpectrumLine;
}  // namespace syncline

/// What a study of a signal's stability says, in words; nothing that its samples do not support.
namespace syncline::ui {

/// Jitter, hunting and drift, told apart by the slopes of the Allan deviation. `quantity`: of the samples.
[[nodiscard]] QString verdictText(const SignalStudy& study, Quantity quantity);
/// "10000 samples, one each 1.00 ms, 2 gaps": what was left out is said.
[[nodiscard]] QString sampleText(const SignalStudy& study);
/// Observation times that have enough windows; empty without any.
[[nodiscard]] QString tauText(const SignalStudy& study);
/// How MTIE stands to `bound` ns, the most that values within the limit can show; `limit` in words.
[[nodiscard]] QString limitText(const SignalStudy& study, double bound, const QString& limit);
/// "task, 250 Hz": what the line of a spectrum may be by its frequency; empty where nothing is known.
[[nodiscard]] QString causeText(const SpectrumLine& line, std::span<const KnownFrequency> known,
                                const SignalStudy& study);

}  // namespace syncline::ui
