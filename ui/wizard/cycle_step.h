// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/wizard/wizard_step.h"

class QLabel;

namespace syncline::ui {

class CycleTable;

/// The network's cycle time, and which cycles the slaves accept.
class CycleStep final : public WizardStep {
  Q_OBJECT

 public:
  explicit CycleStep(MachineDraft& draft);
  ~CycleStep() override;
  [[nodiscard]] QWidget* firstField() const override;
  void refresh() override;
  [[nodiscard]] bool keepsEnter() const override;

 private:
  void showCycles();

  QWidget* cycle_;
  QLabel* limits_;
  CycleTable* cycles_;
};

}  // namespace syncline::ui
