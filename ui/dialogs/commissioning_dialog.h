// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace syncline::reports {
struct Acceptance;
struct AcceptanceLimits;
struct CommissioningFacts;
}  // namespace syncline::reports

namespace syncline::ui {

class Pill;
class Workspace;

/// Whether the run that is shown is accepted, by what, and the page that says so. The verdict follows the fields and
/// the run.
class CommissioningDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit CommissioningDialog(Workspace& workspace, QWidget* parent = nullptr);

  /// Writes the page; where it cannot be written the error is shown and nothing is left of it.
  void write(const QString& path);

 private:
  [[nodiscard]] int wantedWidth();
  void build();
  void refresh();
  void askFile();
  [[nodiscard]] reports::AcceptanceLimits limits() const;
  [[nodiscard]] reports::CommissioningFacts facts() const;
  [[nodiscard]] reports::Acceptance judged() const;

  Workspace& workspace_;
  QLineEdit* machine_;
  QDoubleSpinBox* minutes_;
  QSpinBox *margin_, *lost_, *wkc_, *left_out_, *missed_;
  Pill* verdict_;
  QTableWidget* criteria_;
  QPushButton* write_;
};

}  // namespace syncline::ui
