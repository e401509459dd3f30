// SPDX-License-Identifier: Apache-2.0
#include "ui/text/step_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <optional>
#include <vector>

#include "dc/dcm/predicted_step.h"
#include "record/run_record.h"
#include "trace/step_response.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kLongestStep = 200'000;  // cycles: nobody waits longer for a controller

QString stepWords(const char* text) { return QCoreApplication::translate("StepText", text); }

QString percentText(double part) { return QLocale().toString(std::round(part * 100), 'f', 0); }

QString settlingText(const StepResponse& response) {
  const auto overshoot =
      stepWords(QT_TRANSLATE_NOOP("StepText", "overshoot %1 %")).arg(percentText(response.overshoot));
  const auto settled =
      response.settled ? stepWords(QT_TRANSLATE_NOOP("StepText", "settled after %1")).arg(timeText(*response.settled))
                       : stepWords(QT_TRANSLATE_NOOP("StepText", "not settled"));
  return overshoot + QStringLiteral(", ") + settled;
}

/// What was applied while the machine ran is not in the record.
std::optional<StepResponse> predictedResponse(const RunRecord& record, double step, std::size_t cycles) {
  if (record.snapshot().dcm.times_configured != 0) return std::nullopt;
  const auto cycle = record.config().cycle_time();
  const auto errors = dc::predicted_step(record.config().dc.dcm, cycle, std::llround(step), cycles);
  std::vector<StepResponse::Sample> samples;
  samples.reserve(errors.size());
  for (const double error : errors) samples.push_back({static_cast<Nanoseconds>(samples.size()) * cycle, error});
  return step_response(samples);
}

}  // namespace

QString stepText(const RunRecord& record, Nanoseconds begin, Nanoseconds end) {
  const auto& error = record.samples().series(Signal::kDcmError);
  if (error.count(begin, end) > kLongestStep) return {};
  std::vector<StepResponse::Sample> samples;
  error.for_each(begin, end, [&](Nanoseconds time, float value) {
    if (!std::isnan(value)) samples.push_back({time, static_cast<double>(value)});
  });
  const auto response = step_response(samples);
  if (!response) return {};
  auto text = stepWords(QT_TRANSLATE_NOOP("StepText", "step %1: %2"))
                  .arg(signedTimeText(static_cast<Nanoseconds>(std::llround(response->step))), settlingText(*response));
  if (const auto predicted = predictedResponse(record, response->step, samples.size()))
    text +=
        stepWords(QT_TRANSLATE_NOOP("StepText", " (its controller without noise: %1)")).arg(settlingText(*predicted));
  return text;
}

}  // namespace syncline::ui
