// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <cstddef>
#include <string>
#include <vector>

#include "config/monitor_view.h"
#include "ui/plots/event_marks_item.h"

class QMenu;
class QScrollArea;
class QSplitter;
class QToolButton;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CsvTable;
class CursorSet;
class TimeView;

class FreePlot;
class ValueLabel;

/// Plots that the user puts together, of any signals of the run: views of the project, and usual ones to begin with,
/// which become the project's when they are changed. Shows the views that it is given, and tells of others that the
/// user wants.
class FreeView final : public QWidget {
  Q_OBJECT

 public:
  FreeView(TimeView* view, CursorSet* cursors, QWidget* parent = nullptr);
  ~FreeView() override;

  void setRecord(const RunRecord* record, bool recorded);
  /// Those of the project. The one that is shown stays, by its name.
  void setViews(const std::vector<MonitorView>& views);
  [[nodiscard]] const std::vector<MonitorView>& views() const { return views_; }
  /// Proposed before the usual ones: those of a recording.
  void setOffered(std::vector<MonitorView> views);
  /// By position, whose counters the usual views have; -1: none is chosen.
  void setPickedSlave(int position);
  void setMarks(const std::vector<EventMark>* marks);

  /// What is shown, of the project or usual; empty without a run.
  [[nodiscard]] MonitorView current() const;
  [[nodiscard]] bool showsUsual() const { return usual_ >= 0; }
  /// Of the project, by number.
  void choose(int view);
  void chooseUsual(int number);

  /// What the menu does; a name that another view has gets a number.
  void addView(const MonitorView& view);
  void renameView(const QString& name);
  void duplicateView();
  void removeView();
  void addPlot();
  /// `plot` in place of the one with that number.
  void changePlot(int number, const ViewPlot& plot);
  void movePlot(int number, int by);
  void removePlot(int number);

  [[nodiscard]] const std::vector<FreePlot*>& plots() const { return plots_; }
  /// All plots, and nothing else.
  [[nodiscard]] QWidget* canvas() const;
  void refresh();
  /// Draws all of it, also what the scroll area hides, without the buttons while `on`.
  void setForPicture(bool on);
  /// The samples of what is shown, as LiveStrip::csv().
  [[nodiscard]] CsvTable table(Nanoseconds from, Nanoseconds to) const;

 Q_SIGNALS:
  /// These are the project's views from now on.
  void viewsEdited(const std::vector<syncline::MonitorView>& views);
  /// Plots came or went: plots() are others.
  void plotsChanged();
  /// To be watched besides those that are.
  void variablesWanted();

 private:
  void fillMenu(QMenu& menu);
  void change(MonitorView view);
  void askForName();
  void openSettings(int number);
  void showCurrent();
  void makePlots(std::size_t count);
  void readHeights();
  [[nodiscard]] std::string uniqueName(const std::string& wanted) const;
  [[nodiscard]] std::vector<MonitorView> usual() const;

  TimeView* view_;
  CursorSet* cursors_;
  const RunRecord* record_ = nullptr;
  bool recorded_ = false;
  const std::vector<EventMark>* marks_ = nullptr;
  std::vector<MonitorView> views_, offered_;
  int chosen_ = -1;   // of views_
  int usual_ = 0;     // in its place; -1: none
  MonitorView made_;  // the usual one as it was made
  int picked_ = -1;
  QToolButton *choice_, *add_;
  ValueLabel* hint_;
  QScrollArea* scroll_;
  QSplitter* splitter_;
  std::vector<FreePlot*> plots_;
};

}  // namespace syncline::ui
