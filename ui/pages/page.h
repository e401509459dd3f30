// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <QString>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/snapshot.h"

namespace syncline::ui {

class Workspace;

/// A tab of the device editor for one node. A page shows the project and the live values and asks for
/// edits; it keeps no state of its own.
class Page : public QScrollArea {
  Q_OBJECT

 public:
  Page(Workspace& workspace, const char* object_name, const QString& title);

  [[nodiscard]] const QString& title() const { return title_; }
  /// Position of the shown slave, -1 for the master.
  void setNode(int slave);
  [[nodiscard]] int node() const { return slave_; }
  /// Whether the node has something to show here.
  [[nodiscard]] virtual bool appliesTo(int slave) const = 0;
  /// Shows the project and the compiled configuration as they are now.
  virtual void refresh() = 0;
  /// Shows the live values; only called while visible.
  virtual void showLive(const Snapshot& snapshot) = 0;

 protected:
  void showEvent(QShowEvent* event) override;
  /// One undo step; a refused value is told in the messages and the page shows the project again.
  void edit(const QString& text, const QString& key, const QString& value);
  void edit(const QString& text, const QStringList& keys_and_values);
  [[nodiscard]] Workspace& workspace() const { return workspace_; }

 private:
  Workspace& workspace_;
  QString title_;
  int slave_ = -1;
};

}  // namespace syncline::ui
