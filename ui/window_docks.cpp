// SPDX-License-Identifier: Apache-2.0
#include "ui/window_docks.h"

#include <QDockWidget>
#include <QMainWindow>

#include "ui/main_window.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/findings_panel.h"
#include "ui/panels/messages_panel.h"
#include "ui/panels/trigger_panel.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

WindowDocks::WindowDocks(Workspace& workspace, QMainWindow& window, QDockWidget& catalogue)
    : QObject(&window), workspace_(workspace), window_(window), catalogue_dock_(&catalogue) {
  window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  explorer_ = new ExplorerPanel(workspace);
  explorer_dock_ = dock("explorerDock", MainWindow::tr("Project Explorer"), *explorer_, Qt::LeftDockWidgetArea);
  window.addDockWidget(Qt::RightDockWidgetArea, catalogue_dock_);
  catalogue_dock_->hide();
  messages_ = new MessagesPanel(workspace.messages());
  messages_dock_ = dock("messagesDock", MainWindow::tr("Messages"), *messages_, Qt::BottomDockWidgetArea);
  findings_ = new FindingsPanel(workspace.findings());
  findings_dock_ = dock("findingsDock", MainWindow::tr("Findings"), *findings_, Qt::BottomDockWidgetArea);
  window.tabifyDockWidget(messages_dock_, findings_dock_);
  trigger_ = new TriggerPanel(workspace.trigger());
  trigger_dock_ = dock("triggerDock", MainWindow::tr("Trigger"), *trigger_, Qt::BottomDockWidgetArea);
  window.tabifyDockWidget(findings_dock_, trigger_dock_);
  messages_dock_->raise();
  connect(&workspace.runs(), &NetworkRuns::findingsChanged, this, &WindowDocks::showFindingCount);
  // Of a recording there are some at its end alone.
  for (const auto told : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
    connect(&workspace.findings(), told, this, &WindowDocks::showFindingCount);
  connect(&workspace.recording(), &OpenedRecording::changed, this, &WindowDocks::showRecording);
  showRecording();
}

QDockWidget* WindowDocks::dock(const char* name, const QString& title, QWidget& panel, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(&panel);
  window_.addDockWidget(area, dock);
  return dock;
}

QList<QAction*> WindowDocks::toggles() const {
  return {explorer_dock_->toggleViewAction(), catalogue_dock_->toggleViewAction(), messages_dock_->toggleViewAction(),
          findings_dock_->toggleViewAction(), trigger_dock_->toggleViewAction()};
}

WindowLayout::Parts WindowDocks::parts(WindowCentre& centre) const {
  return {explorer_dock_, catalogue_dock_, {messages_dock_, findings_dock_, trigger_dock_}, &centre};
}

void WindowDocks::showTrigger() {
  trigger_dock_->show();
  trigger_dock_->raise();
}

/// The tab says how much there is, so that nobody has to look whether there is any.
void WindowDocks::showFindingCount() {
  const int count = workspace_.findings().countFrom(Severity::kWarning);
  findings_dock_->setWindowTitle(count == 0 ? MainWindow::tr("Findings") : MainWindow::tr("Findings (%1)").arg(count));
}

void WindowDocks::showRecording() {
  const bool recorded = workspace_.recording().isOpen();
  explorer_dock_->setEnabled(!recorded);
  explorer_dock_->setToolTip(recorded ? MainWindow::tr("A recording is shown; it has no pages of slaves") : QString());
  showFindingCount();
}

}  // namespace syncline::ui
