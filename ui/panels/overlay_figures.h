// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <array>

#include "trace/stretch_figures.h"
#include "ui/plots/trace_panel.h"

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

/// Mean, rms, p99.99 and the largest of deviation and DCM error over the range shown, of the recording and of the one
/// that lies over it. Every sample of the range counts, a portion a tick.
class OverlayFigures final : public QLabel {
  Q_OBJECT

 public:
  explicit OverlayFigures(const TimeView* view, QWidget* parent = nullptr);
  /// Null: nothing. Both must outlive it or be replaced.
  void setSources(const RunRecord* own, const TracePanel::Overlay& overlay);
  /// Counts a portion and writes what there is; once a tick while it is seen.
  void refresh();
  /// All of the range is in.
  [[nodiscard]] bool complete() const;

 private:
  [[nodiscard]] QString cells(const StretchFigures& figures, bool is_signed, bool is_estimate) const;

  const TimeView* view_;
  const RunRecord* own_ = nullptr;
  TracePanel::Overlay overlay_;
  std::array<StretchFigures, 4> figures_;  // deviation and error of the one, then of the other
};

}  // namespace syncline::ui
