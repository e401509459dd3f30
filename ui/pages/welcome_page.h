// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QLabel;

namespace syncline::ui {

/// Stands in the centre while the project has no slaves: the ways to begin.
class WelcomePage final : public QWidget {
  Q_OBJECT

 public:
  explicit WelcomePage(const QList<QAction*>& beginnings, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void drawMark();

  QLabel* mark_;
};

}  // namespace syncline::ui
