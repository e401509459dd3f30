// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QList>

class QMenu;
class QMenuBar;
class QToolBar;
class QToolButton;

namespace syncline::ui {

class Actions;

/// What the menus show beside the actions of the window, as its parts offer it.
struct MenuEntries {
  QMenu* recent = nullptr;
  QMenu* language = nullptr;
  QMenu* exports = nullptr;  // besides the ENI
  QList<QAction*> slaves;    // what is done to slaves
  QList<QAction*> networks;  // to networks of the machine
  QList<QAction*> panels;    // shown or hidden
  QList<QAction*> views;     // of the explorer
  QList<QAction*> pages;     // which of a node are shown
  QList<QAction*> replay;    // of a recording
};

/// Puts the menus into the bar; gives the one of the network back, whose entries depend on what runs.
QMenu* buildMenus(QMenuBar& bar, const Actions& actions, const MenuEntries& entries);

/// Fills the tool bar; gives the button of the states back.
QToolButton* buildToolBar(QToolBar& bar, const Actions& actions);

}  // namespace syncline::ui
