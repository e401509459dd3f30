// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTableView>

namespace syncline::ui {

class EniModel;

/// An ENI, line by line: numbers, what became other, and the XML in colours. Read-only; what is selected can be copied.
class EniTextView final : public QTableView {
  Q_OBJECT

 public:
  explicit EniTextView(EniModel& model, QWidget* parent = nullptr);

  /// Makes a row the current one and shows it with some rows around it, or as the first.
  void goToRow(int row, ScrollHint hint = PositionAtCenter);
  /// The rows that are selected, as text.
  [[nodiscard]] QString selectedText() const;
  /// It is not of the project as it is now, and none will come: greyed.
  void setOutdated(bool outdated);
  [[nodiscard]] bool isOutdated() const { return outdated_; }
  /// Never sideways: the numbers of the lines stay in sight.
  void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;
  /// Gives the columns the room that the text needs.
  void adaptColumns();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  EniModel& model_;
  bool outdated_ = false;
};

}  // namespace syncline::ui
