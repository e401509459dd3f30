// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "findings/finding.h"
#include "trace/signals.h"
#include "ui/theme/theme.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace syncline {
struct OverviewFigure;
class RunRecord;
struct SlavesStanding;
struct SyncLamp;
}  // namespace syncline

namespace syncline::ui {

struct Picture;

class FaultBanner;
class FigureCard;
class Pill;

/// Whether the machine is in sync, since when, with how much margin, and what happened first: the page above the plots
/// while something runs, or a recording is shown. What the numbers are is decided in core/trace/sync_overview.h.
class OverviewPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit OverviewPanel(QWidget* parent = nullptr);
  /// Null: nothing. It must outlive the panel or be replaced.
  void setRecord(const RunRecord* record, bool recorded);
  /// What was found about the run.
  void setFindings(std::vector<Finding> findings);
  /// Something runs: what the lamps say goes on.
  void setLive(bool live);
  /// At once, as the tick does a few times a second.
  void refresh();
  /// What is shown, with a caption, in light colours whatever the theme is. To be drawn at once.
  [[nodiscard]] Picture picture();
  /// The same as text, for a table: a line a figure, its name and its parts separated by tabulators.
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  /// A moment of the run (host clock, ns) was clicked.
  void momentWanted(qint64 moment);
  void armWanted();

 protected:
  bool event(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void openMenu(const QPoint& global);
  void buildVerdict(QWidget& card);
  [[nodiscard]] bool hasNow() const;
  void showLamp(Pill& pill, QLabel& text, const SyncLamp& lamp, const std::optional<SlavesStanding>& standing);
  void showStanding(const std::optional<SlavesStanding>& standing);
  void colorStanding();
  void showFigure(FigureCard& card, const OverviewFigure& figure, Signal signal);
  /// How much of the limit is left, and whether the verdict was lost.
  void showMargin(FigureCard& card, const std::optional<double>& margin, std::int64_t limit, const SyncLamp& lamp,
                  bool lasting);
  void showMissed();

  const RunRecord* record_ = nullptr;
  std::vector<Finding> findings_;
  bool recorded_ = false, live_ = false;
  theme::Tone standing_tone_ = theme::Tone::kNeutral;
  Pill *slaves_, *master_;
  QLabel *slaves_text_, *master_text_, *standing_;
  FaultBanner* banner_;
  FigureCard *deviation_, *missed_, *dcm_;
  QPushButton* arm_;
  QToolButton* menu_;
  QTimer tick_;
};

}  // namespace syncline::ui
