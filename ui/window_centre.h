// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStackedWidget>
#include <optional>

class QSplitter;

namespace syncline::ui {

class DeviceEditor;
class LiveStrip;
class OverlayBar;
class OverviewPanel;
class ReplayBar;
class RunBar;
class StartBar;
class Workspace;

/// The middle of the window: a welcome while there is nothing, else the pages of a node or the overview, and the plots
/// below them.
class WindowCentre final : public QStackedWidget {
  Q_OBJECT

 public:
  /// Takes the welcome page.
  WindowCentre(Workspace& workspace, QWidget* welcome);

  [[nodiscard]] DeviceEditor& editor() const { return *editor_; }
  [[nodiscard]] OverviewPanel& overview() const { return *overview_; }
  [[nodiscard]] LiveStrip& strip() const { return *strip_; }
  [[nodiscard]] RunBar& runBar() const { return *bar_; }
  [[nodiscard]] StartBar& startBar() const { return *start_bar_; }
  [[nodiscard]] ReplayBar& replayBar() const { return *replay_bar_; }
  [[nodiscard]] OverlayBar& overlayBar() const { return *overlay_bar_; }
  [[nodiscard]] QSplitter& splitter() const { return *splitter_; }

  /// How the room is shared while pages and plots are shown, also while they are not: to be kept for the next start.
  [[nodiscard]] QByteArray pageSizes() const;
  void setPageSizes(const QByteArray& sizes);
  /// Whether the plots below the pages are folded, if the user has ever said so; else a low window folds them.
  [[nodiscard]] const std::optional<bool>& foldChoice() const { return fold_choice_; }
  void setFoldChoice(std::optional<bool> folded);

  /// As a new window has it.
  void resetSizes();
  /// While there is nothing to plot, the pages have all the room that the plots can spare; then each its own again.
  void showStrip(bool something);

  void showWelcome(bool welcome) { setCurrentIndex(welcome ? 0 : 1); }
  /// The overview, or the pages, each with the room that they had.
  void showOverview(bool overview);
  [[nodiscard]] bool showsOverview() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Pages and plots share the room, as the user likes.
  [[nodiscard]] bool shares() const { return plots_ && !folded_ && !showsOverview(); }
  void share();
  void foldAsWished();
  /// What is shown changes: each finds the room that it had.
  template <typename Change>
  void rearrange(Change change);

  DeviceEditor* editor_;
  OverviewPanel* overview_;
  LiveStrip* strip_;
  RunBar* bar_;
  StartBar* start_bar_;
  ReplayBar* replay_bar_;
  OverlayBar* overlay_bar_;
  QSplitter* splitter_;
  QStackedWidget* upper_;  // editor or overview
  bool plots_ = false;     // there is something to plot
  bool folded_ = false;    // of the plots below the pages the figures alone are shown
  std::optional<bool> fold_choice_;
  QByteArray page_sizes_;  // while they do not share; empty: as a new window has them
};

}  // namespace syncline::ui
