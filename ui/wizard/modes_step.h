// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/wizard/wizard_step.h"

class QLabel;
class QTableView;

namespace syncline::ui {

class DcModeModel;

/// The DC operation mode and the Sync Unit Cycle of each slave, in one table.
class ModesStep final : public WizardStep {
  Q_OBJECT

 public:
  explicit ModesStep(MachineDraft& draft);
  ~ModesStep() override;
  [[nodiscard]] QWidget* firstField() const override;
  void refresh() override;
  [[nodiscard]] bool keepsEnter() const override;

 private:
  QTableView* table_;
  QLabel* note_;
  DcModeModel* model_;
};

}  // namespace syncline::ui
