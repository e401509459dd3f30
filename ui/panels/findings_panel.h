// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QTableView;

namespace syncline::ui {

class FindingModel;

/// What is wrong with the running bus, why, and what to do; activating a row goes to its field, or else its slave.
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
  /// `key`: of the setting that would mend it; may be empty.
  void placeActivated(int slave, const QString& key);
  /// What was found began at this moment of the run (host clock, ns).
  void momentActivated(qint64 moment);

 private:
  void showState();

  FindingModel& model_;
  QTableView* table_;
  QLabel* nothing_;
};

}  // namespace syncline::ui
