// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "findings/finding.h"

class QLabel;
class QMenu;
class QTableView;

namespace syncline::ui {

class FindingModel;

/// What is wrong with the project and with the running bus, why, and what to do; activating a row goes to its field, or
/// else its slave.
class FindingsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit FindingsPanel(FindingModel& model, QWidget* parent = nullptr);
  /// Selects what was found of a moment of the run, if anything was.
  void selectMoment(qint64 moment);
  /// Nothing can be known yet: a moment of a recording is shown, whose findings are those of its end.
  void setUntold(bool untold);
  [[nodiscard]] QSize sizeHint() const override { return {800, 128}; }

 Q_SIGNALS:
  void findingActivated(const syncline::Finding& finding);
  /// What was found began at this moment of the run (host clock, ns).
  void momentActivated(qint64 moment);
  /// The context menu of a row is about to open: whoever can do something about it adds what he can.
  void menuOpens(QMenu& menu, const syncline::Finding& finding);

 private:
  void openMenu(const QPoint& at);
  void showState();

  FindingModel& model_;
  QTableView* table_;
  QLabel* nothing_;
};

}  // namespace syncline::ui
