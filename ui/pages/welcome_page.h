// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

class QAction;
class QLabel;

namespace syncline::ui {

class WindowMemory;

/// Stands in the centre while the project has no slaves: the ways to begin, and the projects that were open lately.
class WelcomePage final : public QWidget {
  Q_OBJECT

 public:
  WelcomePage(const QList<QAction*>& beginnings, WindowMemory& memory, QWidget* parent = nullptr);

 Q_SIGNALS:
  void fileWanted(const QString& path);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void drawMark();
  void showRecent();
  QWidget* makeRecent(int row, const QString& path, bool pinned);

  WindowMemory& memory_;
  QWidget* recent_ = nullptr;
  QLabel* mark_;
};

}  // namespace syncline::ui
