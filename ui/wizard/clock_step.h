// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/wizard/wizard_step.h"

class QCheckBox;
class QLabel;
class QTableWidget;

namespace syncline::ui {

class ChoiceEdit;

/// Whether the slaves' clocks are synchronised, and which of them leads.
class ClockStep final : public WizardStep {
  Q_OBJECT

 public:
  explicit ClockStep(MachineDraft& draft);
  ~ClockStep() override;
  [[nodiscard]] QWidget* firstField() const override;
  void refresh() override;

 private:
  void showCandidates();

  QCheckBox* enabled_;
  ChoiceEdit* reference_;
  QLabel* leader_;
  QTableWidget* candidates_;
};

}  // namespace syncline::ui
