// SPDX-License-Identifier: Apache-2.0
#include "ui/window_menus.h"

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <QWhatsThis>

#include "ui/actions.h"
#include "ui/main_window.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

void buildFileMenu(QMenu& menu, const Actions& actions, const MenuEntries& entries) {
  menu.addActions({actions.create, actions.new_machine, actions.open});
  menu.addMenu(entries.recent);
  menu.addAction(actions.close_recording);
  menu.addActions({actions.save, actions.save_as, actions.save_template});
  menu.addSeparator();
  menu.addActions({actions.export_eni, actions.export_report});
  menu.addMenu(entries.exports);
  menu.addAction(actions.compare);
  menu.addSeparator();
  menu.addAction(actions.quit);
}

void buildEditMenu(QMenu& menu, const Actions& actions, const QList<QAction*>& slaves) {
  menu.addActions({actions.undo, actions.redo});
  menu.addSeparator();
  menu.addActions(slaves);
  menu.addSeparator();
  menu.addAction(actions.go_to);
}

void buildNetworkMenu(QMenu& menu, const Actions& actions, const MenuEntries& entries) {
  menu.addActions({actions.scan, actions.demo});
  menu.addSeparator();
  menu.addActions({actions.choose_link, actions.online, actions.offline});
  menu.addMenu(MainWindow::tr("Request S&tate"))->addActions(actions.states);
  menu.addSeparator();
  menu.addActions({actions.record, actions.save_recent, actions.memory, actions.black_box});
  auto* replay = menu.addMenu(MainWindow::tr("Re&play"));
  replay->setObjectName(QStringLiteral("menuReplay"));
  replay->addActions(entries.replay);
  menu.addActions({actions.overlay, actions.import_capture});
  menu.addSeparator();
  menu.addActions({actions.commissioning, actions.clear_statistics});
  menu.addSeparator();
  menu.addActions(entries.networks);
}

void buildViewMenu(QMenu& menu, const Actions& actions, const MenuEntries& entries) {
  menu.addActions(entries.panels);
  menu.addAction(actions.reset_layout);
  menu.addSeparator();
  menu.addActions(entries.views);
  menu.addSeparator();
  menu.addActions(entries.pages);
  menu.addSeparator();
  menu.addActions({actions.overview, actions.expert});
  menu.addSeparator();
  menu.addActions(actions.themes);
  menu.addSeparator();
  menu.addMenu(entries.language);
}

/// What is told of the field that has the focus, or that it is in; without one the pointer asks.
void showFieldHelp() {
  for (auto* at = QApplication::focusWidget(); at != nullptr; at = at->parentWidget()) {
    if (!at->whatsThis().isEmpty())
      return QWhatsThis::showText(at->mapToGlobal(QPoint(0, at->height())), at->whatsThis(), at);
  }
  QWhatsThis::enterWhatsThisMode();
}

}  // namespace

QMenu* buildMenus(QMenuBar& bar, const Actions& actions, const MenuEntries& entries) {
  buildFileMenu(*bar.addMenu(MainWindow::tr("&File")), actions, entries);
  buildEditMenu(*bar.addMenu(MainWindow::tr("&Edit")), actions, entries.slaves);
  auto* network = bar.addMenu(MainWindow::tr("&Network"));
  buildNetworkMenu(*network, actions, entries);
  buildViewMenu(*bar.addMenu(MainWindow::tr("&View")), actions, entries);
  auto* help = bar.addMenu(MainWindow::tr("&Help"));
  auto* field = new QAction(MainWindow::tr("&Help on the Field"), &bar);
  field->setObjectName(QStringLiteral("actionFieldHelp"));
  field->setShortcut(QKeySequence::WhatsThis);
  field->setToolTip(MainWindow::tr("Range, default and key of the field that has the focus"));
  QObject::connect(field, &QAction::triggered, &bar, &showFieldHelp);
  auto* what = QWhatsThis::createAction(&bar);
  what->setObjectName(QStringLiteral("actionWhatsThis"));
  what->setShortcut({});  // of the field's help, which comes to this where there is none
  help->addActions({field, what, actions.about});
  return network;
}

QToolButton* buildToolBar(QToolBar& bar, const Actions& actions) {
  bar.setObjectName(QStringLiteral("mainToolBar"));
  bar.setMovable(false);
  bar.setIconSize(QSize(20, 20));
  bar.setToolButtonStyle(Qt::ToolButtonIconOnly);
  bar.addActions({actions.create, actions.open, actions.save, actions.save_as});
  bar.addSeparator();
  bar.addActions({actions.undo, actions.redo});
  bar.addSeparator();
  bar.addActions({actions.scan, actions.export_eni});
  bar.addSeparator();
  bar.addActions({actions.online, actions.offline, actions.record, actions.overview});
  auto* states = named(new QToolButton, "requestState", MainWindow::tr("Request a state for all slaves"));
  states->setText(MainWindow::tr("Request State"));
  states->setToolTip(MainWindow::tr("Request a state for all slaves (register 0x0120)"));
  states->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(states);
  menu->addActions(actions.states);
  states->setMenu(menu);
  bar.addWidget(states);
  auto* gap = new QWidget;
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar.addWidget(gap);
  bar.addAction(actions.toggle_theme);
  for (auto* action : {actions.scan, actions.export_eni, actions.online, actions.offline}) {
    if (auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(action)))
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  for (auto* action : bar.actions()) {
    auto* button = bar.widgetForAction(action);
    if (button != nullptr && button->accessibleName().isEmpty()) button->setAccessibleName(action->toolTip());
  }
  return states;
}

}  // namespace syncline::ui
