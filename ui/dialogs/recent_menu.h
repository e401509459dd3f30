// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>

namespace syncline::ui {

class ProjectDocument;
class WindowMemory;

/// The projects that were open lately; pinned ones stay on top.
class RecentMenu final : public QMenu {
  Q_OBJECT

 public:
  RecentMenu(WindowMemory& memory, ProjectDocument& document, QWidget* parent);

 Q_SIGNALS:
  void fileWanted(const QString& path);

 private:
  void fill();

  WindowMemory& memory_;
  ProjectDocument& document_;
};

}  // namespace syncline::ui
