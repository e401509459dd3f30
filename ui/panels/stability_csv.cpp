// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "record/run_record.h"
#include "support/csv_field.h"
#include "ui/panels/stability_view.h"

namespace syncline::ui {
namespace {

/// Empty where there is none.
std::string figureCell(double value) { return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value); }

void addFigures(std::string& text, const std::string& key, const SignalStudy& study) {
  for (const auto& point : study.points) {
    fmt::format_to(std::back_inserter(text), "{},{:.9g},{},{},{},{},{}\n", key, point.tau, figureCell(point.adev),
                   figureCell(point.mdev), figureCell(point.tdev), figureCell(point.mtie), point.windows);
  }
}

void addAmplitudes(std::string& text, const std::string& key, const Spectrum& spectrum) {
  for (std::size_t i = 0; i < spectrum.amplitudes.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{:.9g},{}\n", key, static_cast<double>(i) * spectrum.step,
                   figureCell(spectrum.amplitudes[i]));
  }
}

}  // namespace

std::string StabilityView::csv() const {
  const bool spectrum = figure() == Figure::kSpectrum;
  // What variables count nobody knows here.
  const std::string unit = ofVariables() ? "" : "_ns";
  auto text = spectrum ? fmt::format("signal,frequency_hz,amplitude{}\n", unit)
                       : fmt::format("signal,tau_s,adev,mdev,tdev{},mtie{},windows\n", unit, unit);
  for (const auto& studied : studied_) {
    if (studied.study == nullptr) continue;
    const auto key = csv_field(keyOf(*record_, studied.source));
    if (spectrum) {
      addAmplitudes(text, key, studied.study->spectrum);
    } else {
      addFigures(text, key, *studied.study);
    }
  }
  return text;
}

}  // namespace syncline::ui
