// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "findings/finding.h"
#include "record/replay_run.h"
#include "ui/panels/cycle_view.h"
#include "ui/panels/stability_view.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/trace_panel.h"

namespace syncline {
struct ReplayedRun;
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

/// What a picture of a run shows, by the names that the window has for it.
enum class PictureView : std::uint8_t { kOverview, kPlots, kDistribution, kStability, kCycle, kSlaves, kFree };

/// What a picture of a recording is to be; what is not said is as the window has it at first.
struct RecordingPicture {
  PictureView view = PictureView::kPlots;
  /// Host clock, ns, both belong to it; nothing: all of the recording. The overview's is since it was armed.
  struct Range {
    Nanoseconds begin = 0, end = 0;
  };
  std::optional<Range> range{};
  std::vector<SignalSource> sources{};  // of distribution, stability and the user's own plots
  QString own_view{};                   // of the project in the recording: its name; empty: the first one
  std::optional<StabilityView::Figure> figure{};
  std::optional<CycleView::Figure> cycle_figure{};
  int slave = -1;                 // whose curves the plots draw in any case, whose cycle it is
  TracePanel::Overlay overlay{};  // of the views kPlots and kDistribution: what lies over it
  QSize size{};                   // of the picture in pixels of a screen; empty: what suits the view
};

/// "overview", "plots", "distribution", "stability", "cycle", "slaves", "free".
[[nodiscard]] std::optional<PictureView> pictureViewOf(const QString& name);
[[nodiscard]] QStringList pictureViewNames();
/// "adev", "tdev", "mtie", "spectrum".
[[nodiscard]] std::optional<StabilityView::Figure> stabilityFigureOf(const QString& name);
/// "arrivals", "bathtub".
[[nodiscard]] std::optional<CycleView::Figure> cycleFigureOf(const QString& name);
/// "dcm_error_ns", and "deviation_ns@3" of slave 3. kBadValue where the run has no such signal to show.
[[nodiscard]] Result<SignalSource> signalSourceOf(const QString& text, const RunRecord& record);

/// The same of any signal that can be drawn, "al_status@3" and "lost_frames_total", too, and of a variable by its name.
[[nodiscard]] Result<SignalSource> drawnSignalOf(const QString& text, const RunRecord& record);

/// Draws it with the widgets of the window, which nobody sees, and writes PNG, SVG or PDF by the ending of the name, or
/// what is drawn as a table (CSV; the overview has none). In
/// the thread of the window; lets it work until every figure is made. kBadValue where the view has nothing to show of
/// this run, and as writePicture(); kTimeout when the figures are not made within a minute.
[[nodiscard]] Status writeRecordingPicture(const ReplayedRun& run, const RecordingPicture& wanted, const QString& path);

}  // namespace syncline::ui
