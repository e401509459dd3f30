// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/wizard/wizard_step.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace syncline::ui {

class FindingModel;

/// What the machine is, what compiler and ENI checker find, and whether the ENI is wanted at once.
class SummaryStep final : public WizardStep {
  Q_OBJECT

 public:
  explicit SummaryStep(MachineDraft& draft);
  [[nodiscard]] QString whyNotOn() const override;
  [[nodiscard]] bool keepsEnter() const override;
  [[nodiscard]] QWidget* firstField() const override;
  void refresh() override;
  /// Where the ENI is wanted; empty: it is not.
  [[nodiscard]] QString exportPath() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildExport();
  void showFindings();
  void browse();

  QLabel *slaves_, *cycle_, *clock_, *mode_, *window_, *verdict_;
  QTableView* table_;
  FindingModel* findings_;
  QCheckBox* export_;
  QLineEdit* path_;
  QPushButton* browse_;
};

}  // namespace syncline::ui
