// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QTimer>
#include <QWidget>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "record/run_record.h"
#include "ui/panels/picture_file.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/event_marks_item.h"
#include "ui/plots/trace_panel.h"

class QLabel;
class QMenu;
class QStackedLayout;
class QToolButton;

namespace syncline::ui {

class CsvTable;

class CsvExport;
class CycleView;
class DistributionView;
class FreeView;
class LiveStripToolbar;
class OverlayFigures;
class SlavesView;
class StabilityView;
class VariablesRow;

/// Three plots over one time axis: DC deviation, missed SM2 events, DCM error; below them those of the variables that
/// are watched. Draws what a run's record holds on a
/// tick of its own, only what can be seen; names and limits are those of the configuration that runs.
class LiveStrip : public QWidget {
  Q_OBJECT

 public:
  explicit LiveStrip(QWidget* parent = nullptr);
  ~LiveStrip() override;

  /// What is drawn; null: nothing. It must outlive the strip or be replaced.
  /// Of a recording all is shown at first, and nothing is followed.
  void setRecord(const RunRecord* record, bool recorded = false);
  /// The recording is shown at another moment, or whole: RunRecord::shown_at(). A moment is followed as the newest
  /// sample of a run is. `back`: samples that were there may be there no more.
  void showMoment(bool back);
  /// Another recording over what is shown, in the three plots, with the figures of both below them; see TracePanel.
  void setOverlay(const TracePanel::Overlay& overlay);
  [[nodiscard]] OverlayFigures* overlayFigures() const { return overlay_figures_; }
  /// Colours from the palette that is set now; palette changes call it by themselves.
  void applyTheme();
  /// The slave that the deviation and SM2 plots draw in any case; -1 = only the worst.
  void setPickedSlave(int position);
  /// Puts a moment into the middle of the plots, with cursor A on it; what stands in their place goes.
  void goTo(Nanoseconds time);
  /// As goTo(); a stretch fills the plots, with cursor A on a moment of it; `freeze`: the picture says that it stands.
  void showRange(Nanoseconds from, Nanoseconds to, Nanoseconds moment, bool freeze);
  /// Those of the project, see FreeView.
  void setViews(const std::vector<MonitorView>& views);
  /// Only headings and legends are left of the plots, as high as these need; the views in place of the plots wait.
  void setFolded(bool folded);
  [[nodiscard]] bool isFolded() const { return folded_; }
  /// Whether there is a button that folds it.
  void setFoldable(bool foldable);
  /// Proposed besides: those of a recording.
  void setOfferedViews(std::vector<MonitorView> views);
  /// Limits of the project in work, which may be dragged and typed; nothing: what is shown is not of it.
  void setWantedLimits(const std::optional<RunLimits>& limits);
  /// The level of a trigger, drawn where its signal is; nothing: none.
  struct TriggerLevel {
    Signal signal = Signal::kDeviation;
    std::size_t slave = 0;  // or the variable's number
    std::optional<double> level;
  };
  void setTriggerLevel(const TriggerLevel& level);
  /// Asks for a file and writes the samples of a stretch, as csv() does of what is shown.
  void exportRange(Nanoseconds from, Nanoseconds to);

  /// One redraw, as the tick does; for tests and pictures.
  void refresh();
  [[nodiscard]] TimeView* timeView() { return &view_; }
  [[nodiscard]] CursorSet* cursors() { return &cursors_; }
  [[nodiscard]] const SampleStore* store() const { return record_ == nullptr ? nullptr : &record_->samples(); }
  [[nodiscard]] const std::array<TracePanel*, 3>& panels() const { return panels_; }
  [[nodiscard]] VariablesRow* variables() const { return variables_; }
  [[nodiscard]] DistributionView* distribution() const { return distribution_; }
  [[nodiscard]] StabilityView* stability() const { return stability_; }
  [[nodiscard]] SlavesView* slaves() const { return slaves_; }
  [[nodiscard]] CycleView* cycle() const { return cycle_; }
  [[nodiscard]] FreeView* free() const { return free_; }
  /// The plots over time, or in their place those of the user's own, histograms, curves over observation times and
  /// spectra, all slaves, or the SYNC0 period of one.
  enum class Body : std::uint8_t { kPlots, kDistribution, kStability, kSlaves, kCycle, kFree };
  void showBody(Body body);
  /// The bins of the distribution, the figures of the stability, the cells of the slaves or the arrivals of the cycle
  /// where they are shown; else the stretch that is shown as a table: times in ns since the run began and in UTC, one
  /// column a series; C locale.
  [[nodiscard]] std::string csv() const;
  /// The same of a stretch of the plots over time, or of the user's own.
  [[nodiscard]] CsvTable table(Nanoseconds from, Nanoseconds to) const;
  /// Writes it, with progress and Cancel.
  void exportTable(const QString& path, CsvTable table);
  /// What is shown, with a caption, in light colours whatever the theme is. To be drawn at once.
  [[nodiscard]] Picture picture();
  /// The figures of the plots that are shown, a line a curve, for a spreadsheet.
  [[nodiscard]] QString figures() const;

 Q_SIGNALS:
  /// It is to be folded, or not any more: by its own buttons. plotsWanted(): because something is to be shown in them.
  void foldWanted(bool folded);
  void plotsWanted();
  /// So many slaves are to be drawn by the panel of this name, the worst of them.
  void slavesShownChosen(const QString& panel, int count);
  /// A note is to be written at this moment, or the one that is there to be changed.
  void noteWanted(syncline::Nanoseconds time);
  /// What lies over the plots is to be later by so many ns.
  void overlayMoved(syncline::Nanoseconds by);
  /// Of a recording: this moment is to be shown, as now.
  void momentWanted(syncline::Nanoseconds time);
  /// Esc, where there was nothing else to give up.
  void escaped();
  /// The mark of an event was clicked.
  void eventClicked(syncline::Nanoseconds time);
  void triggerWanted();
  void triggerLevelDragged(double level);
  /// Another limit of the signal in the project, ns.
  void limitWanted(syncline::Signal signal, double magnitude);
  /// A slave of the run, by position, was chosen.
  void slaveWanted(int position);
  /// These are the project's views from now on.
  void viewsEdited(const std::vector<syncline::MonitorView>& views);
  /// The page on which variables are chosen to be watched.
  void variablesWanted();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void mark(Nanoseconds time);
  void showEventAt(Nanoseconds time);
  void tick();
  void refreshTexts(bool choose);
  void showState();
  [[nodiscard]] QWidget* body() const;
  void showTriggerLevel();
  void collectMarks();
  void collectNotes();
  void attachViews();
  [[nodiscard]] int leastHeight() const;
  [[nodiscard]] Nanoseconds notePlace(Nanoseconds time) const;
  void followRecord();
  [[nodiscard]] bool hasSamples() const { return record_ != nullptr && !record_->samples().empty(); }
  void adopt(TracePanel* panel);
  void gatherPanels();
  /// Those that are over time and shown now.
  [[nodiscard]] std::vector<TracePanel*> shownPanels() const;
  /// Of the plot that has the focus.
  [[nodiscard]] TimeView& activeView();
  void openMenu(const QPoint& global, Nanoseconds time, TracePanel* panel = nullptr);
  void addPlotActions(QMenu& menu, TracePanel& panel);
  void addSlaveCounts(QMenu& menu, TracePanel& panel);
  void addAxisActions(QMenu& menu);
  void addCursorActions(QMenu& menu, Nanoseconds time);
  void addRecordingActions(QMenu& menu, Nanoseconds time);
  void askForDistance();
  void askForLimit(TracePanel& panel);
  void exportCsv();
  [[nodiscard]] CsvTable tableOfAll(Nanoseconds from, Nanoseconds to) const;
  void exportPicture();
  void copyPicture();
  void zoomAtMiddle(double factor);
  [[nodiscard]] Nanoseconds cursorPlace() const;

  TimeView view_;
  CursorSet cursors_;
  const RunRecord* record_ = nullptr;
  bool recorded_ = false;
  LiveStripToolbar* toolbar_;
  QStackedLayout* stack_;
  QLabel* empty_;
  QWidget* plots_;
  DistributionView* distribution_;
  StabilityView* stability_;
  SlavesView* slaves_;
  CycleView* cycle_;
  FreeView* free_;
  CsvExport* csv_export_ = nullptr;
  std::array<TracePanel*, 3> panels_{};
  VariablesRow* variables_;
  OverlayFigures* overlay_figures_;
  std::vector<TracePanel*> fixed_panels_;  // those of the variables, too
  std::vector<TracePanel*> all_panels_;    // and those of the user's own
  QTimer tick_;
  unsigned ticks_ = 0;
  std::vector<EventMark> marks_;  // of the record's events, by time
  std::uint64_t marked_ = 0;      // events that were looked at
  std::uint64_t noted_ = 0;       // RunRecord::notes_changed() when the notes were looked at
  std::size_t notes_marked_ = 0;
  TriggerLevel level_;
  std::optional<RunLimits> wanted_limits_;
  Body body_ = Body::kPlots;
  QToolButton* unfold_;
  bool folded_ = false;
  bool text_wanted_ = false;
};

}  // namespace syncline::ui
