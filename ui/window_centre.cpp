// SPDX-License-Identifier: Apache-2.0
#include "ui/window_centre.h"

#include <QSplitter>
#include <QVBoxLayout>

#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/overlay_bar.h"
#include "ui/panels/overview_panel.h"
#include "ui/panels/recording_bar.h"
#include "ui/panels/replay_bar.h"
#include "ui/panels/run_bar.h"
#include "ui/panels/start_bar.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

constexpr int kPagesHeight = 385, kPlotsHeight = 215;  // of a new window, and their shares of another one
constexpr int kHeightForBoth = 480;                    // less is not enough for a page and plots

QVBoxLayout* closeColumn(QWidget& area) {
  auto* layout = new QVBoxLayout(&area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  return layout;
}

}  // namespace

WindowCentre::WindowCentre(Workspace& workspace, QWidget* welcome)
    : editor_(new DeviceEditor(workspace)),
      overview_(new OverviewPanel),
      strip_(new LiveStrip),
      bar_(new RunBar(workspace.runDifference())),
      start_bar_(new StartBar(workspace.startRefusal())),
      replay_bar_(new ReplayBar(workspace.replay())),
      overlay_bar_(new OverlayBar(workspace.overlay(), workspace.trigger())),
      splitter_(new QSplitter(Qt::Vertical)),
      upper_(new QStackedWidget) {
  strip_->setObjectName(QStringLiteral("liveStrip"));
  strip_->setAccessibleName(MainWindow::tr("Live plots"));
  strip_->setMinimumWidth(600);
  strip_->setMaximumHeight(strip_->minimumHeight());
  upper_->addWidget(editor_);
  upper_->addWidget(overview_);
  // Below the pages: what comes and goes with an edit moves no field away from the pointer.
  auto* pages = new QWidget;
  auto* column = closeColumn(*pages);
  column->addWidget(upper_, 1);
  column->addWidget(bar_);
  column->addWidget(start_bar_);
  splitter_->setObjectName(QStringLiteral("centreSplitter"));
  splitter_->addWidget(pages);
  splitter_->addWidget(strip_);
  splitter_->setChildrenCollapsible(false);
  splitter_->setStretchFactor(0, 3);
  splitter_->setStretchFactor(1, 2);
  connect(strip_, &LiveStrip::foldWanted, this, &WindowCentre::setFoldChoice);
  connect(strip_, &LiveStrip::plotsWanted, this, [this] { rearrange([this] { folded_ = false; }); });
  auto* working = new QWidget;
  auto* layout = closeColumn(*working);
  layout->addWidget(new RecordingBar(workspace.recording(), replay_bar_));
  layout->addWidget(overlay_bar_);
  layout->addWidget(splitter_, 1);
  addWidget(welcome);
  addWidget(working);
}

bool WindowCentre::showsOverview() const { return upper_->currentWidget() == overview_; }

QByteArray WindowCentre::pageSizes() const { return shares() ? splitter_->saveState() : page_sizes_; }

void WindowCentre::setPageSizes(const QByteArray& sizes) {
  page_sizes_ = sizes;
  if (shares()) share();
}

void WindowCentre::share() {
  if (page_sizes_.isEmpty()) return splitter_->setSizes({kPagesHeight, kPlotsHeight});
  splitter_->restoreState(page_sizes_);
}

template <typename Change>
void WindowCentre::rearrange(Change change) {
  page_sizes_ = pageSizes();
  change();
  strip_->setFolded(folded_ && plots_ && !showsOverview());
  strip_->setFoldable(!showsOverview());
  const bool fixed = !plots_ || strip_->isFolded();
  strip_->setMaximumHeight(fixed ? strip_->minimumHeight() : QWIDGETSIZE_MAX);
  if (shares()) share();
}

void WindowCentre::setFoldChoice(std::optional<bool> folded) {
  fold_choice_ = folded;
  foldAsWished();
}

void WindowCentre::foldAsWished() {
  const bool folded = fold_choice_.value_or(height() < kHeightForBoth);
  if (folded != folded_) rearrange([&] { folded_ = folded; });
}

void WindowCentre::resizeEvent(QResizeEvent* event) {
  QStackedWidget::resizeEvent(event);
  foldAsWished();
}

void WindowCentre::resetSizes() {
  setFoldChoice(std::nullopt);
  page_sizes_.clear();
  splitter_->setSizes({kPagesHeight, kPlotsHeight});
}

void WindowCentre::showStrip(bool something) {
  if (something != plots_) rearrange([&] { plots_ = something; });
}

/// The overview needs less room than the pages; what it leaves is the plots'. The pages find theirs as they left it.
void WindowCentre::showOverview(bool overview) {
  if (overview == showsOverview()) return;
  rearrange([&] { upper_->setCurrentWidget(overview ? static_cast<QWidget*>(overview_) : editor_); });
  if (!overview) return;
  const auto sizes = splitter_->sizes();
  const int height = overview_->sizeHint().height();
  splitter_->setSizes({height, sizes.front() + sizes.back() - height});
}

}  // namespace syncline::ui
