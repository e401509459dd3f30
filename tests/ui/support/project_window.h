// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QTabWidget>
#include <QUndoStack>

#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/session/workspace.h"
#include "ui_test_support.h"

namespace syncline::test {

/// The window on a project, active, so that keys reach its fields.
class ProjectWindow : public ::testing::Test {
 protected:
  explicit ProjectWindow(const Project& machine) : workspace_(virtualEnvironment()), window_(workspace_) {
    workspace_.document().replace(QStringLiteral("load"), machine);
    workspace_.document().undoStack().setClean();
    window_.show();
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
  }
  ~ProjectWindow() override { workspace_.document().undoStack().setClean(); }

  const Project& project() { return workspace_.document().project(); }
  template <class Widget = QWidget>
  Widget& field(const char* name) {
    return *find<Widget>(window_, name);
  }
  /// False where the node has no such page.
  bool has(int node, const char* page) {
    window_.selectNode(node);
    auto* tabs = window_.editor().tabs();
    for (int i = 0; i < tabs->count(); ++i) {
      if (tabs->widget(i)->objectName() == QLatin1String(page)) tabs->setCurrentIndex(i);
    }
    return tabs->currentWidget()->objectName() == QLatin1String(page);
  }
  void show(int node, const char* page) { ASSERT_TRUE(has(node, page)) << page; }

  ui::Workspace workspace_;
  ui::MainWindow window_;
};

}  // namespace syncline::test
