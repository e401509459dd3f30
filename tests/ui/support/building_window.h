// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDragEnterEvent>
#include <QDragMoveEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QTreeView>
#include <memory>

#include "config/slave_edits.h"
#include "own_cache.h"
#include "project_window.h"
#include "ui/models/network_model.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/topology_view.h"

namespace syncline::test {

inline DeviceDescription plain(const char* type, const char* physics) {
  DeviceDescription device;
  device.type = type;
  device.name = type;
  device.physics = physics;
  device.identity.product_code = static_cast<std::uint32_t>(qHash(QLatin1String(type)) | 1U);
  return device;
}

/// Coupler, two terminals, junction, drive.
inline Project plant() {
  Project project;
  EXPECT_TRUE(add_slave(project, plain("Coupler", "YKY"), {}));
  EXPECT_TRUE(add_slave(project, plain("Terminal", "KK"), 0));
  EXPECT_TRUE(add_slave(project, plain("Terminal", "KK"), 0));
  EXPECT_TRUE(add_slave(project, plain("Junction", "YYYY"), 0));
  EXPECT_TRUE(add_slave(project, plain("Drive", "YY"), 3));
  return project;
}

/// A machine whose slaves are added, moved and wired by hand.
class Building : private OwnCache, public ProjectWindow {
 protected:
  explicit Building(const Project& machine = plant()) : ProjectWindow(machine) {}
  ~Building() override { workspace_.document().undoStack().setClean(); }

  QTreeView& tree() { return field<QTreeView>("explorerTree"); }
  ui::TopologyView& topology() { return window_.explorer().topology(); }
  int steps() { return workspace_.document().undoStack().index(); }
  QString types() {
    QStringList all;
    for (const auto& slave : project().slaves) all << QString::fromStdString(slave.device.type);
    return all.join(u' ');
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    tree().setFocus();
    QTest::keyClick(&tree(), key, modifiers);
  }
  int selected() { return window_.explorer().selected(); }
  std::unique_ptr<QMimeData> dragged(int slave) {
    auto& network = workspace_.network();
    return std::unique_ptr<QMimeData>(network.mimeData({network.indexOf(slave)}));
  }
  /// In the tree, as the mouse does it; false where it is refused.
  bool drop(const QMimeData& data, QPoint point) {
    auto* viewport = tree().viewport();
    QDragEnterEvent enter(point, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(viewport, &enter);
    QDragMoveEvent move(point, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(viewport, &move);
    if (!move.isAccepted()) return false;
    QDropEvent dropped(point, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(viewport, &dropped);
    return true;
  }
};

}  // namespace syncline::test
