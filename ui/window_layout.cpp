// SPDX-License-Identifier: Apache-2.0
#include "ui/window_layout.h"

#include <QDockWidget>
#include <QMainWindow>
#include <utility>

#include "ui/session/window_memory.h"
#include "ui/window_centre.h"

namespace syncline::ui {
namespace {

constexpr int kLayout = 3;  // one more with every panel that comes or goes
const QString kLayoutVersion = QStringLiteral("layout/version"), kGeometry = QStringLiteral("layout/geometry"),
              kState = QStringLiteral("layout/state"), kSplitter = QStringLiteral("layout/splitter"),
              kFolded = QStringLiteral("layout/plotsFolded");

}  // namespace

WindowLayout::WindowLayout(QMainWindow& window, WindowMemory& memory, Parts parts)
    : window_(window), memory_(memory), parts_(std::move(parts)) {}

void WindowLayout::reset() {
  const auto place = [this](QDockWidget* dock, Qt::DockWidgetArea area) {
    dock->setFloating(false);
    dock->show();
    window_.addDockWidget(area, dock);
  };
  place(parts_.explorer, Qt::LeftDockWidgetArea);
  place(parts_.catalogue, Qt::RightDockWidgetArea);
  parts_.catalogue->hide();
  auto* first = parts_.below.front();
  for (auto* dock : parts_.below) {
    place(dock, Qt::BottomDockWidgetArea);
    if (dock != first) window_.tabifyDockWidget(first, dock);
  }
  first->raise();
  window_.resizeDocks({parts_.explorer, parts_.catalogue}, {272, 280}, Qt::Horizontal);
  window_.resizeDocks({first}, {128}, Qt::Vertical);
  parts_.centre->resetSizes();
}

void WindowLayout::recall() {
  if (memory_.value(kLayoutVersion).toInt() != kLayout) return;
  window_.restoreGeometry(memory_.value(kGeometry).toByteArray());
  window_.restoreState(memory_.value(kState).toByteArray(), kLayout);
  parts_.centre->setPageSizes(memory_.value(kSplitter).toByteArray());
  if (const auto folded = memory_.value(kFolded); folded.isValid()) parts_.centre->setFoldChoice(folded.toBool());
}

void WindowLayout::remember() {
  memory_.setValue(kLayoutVersion, kLayout);
  memory_.setValue(kGeometry, window_.saveGeometry());
  memory_.setValue(kState, window_.saveState(kLayout));
  memory_.setValue(kSplitter, parts_.centre->pageSizes());
  const auto& folded = parts_.centre->foldChoice();
  memory_.setValue(kFolded, folded ? QVariant(*folded) : QVariant());
}

}  // namespace syncline::ui
