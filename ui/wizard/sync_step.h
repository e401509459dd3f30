// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "ui/wizard/wizard_step.h"

class QButtonGroup;
class QCheckBox;
class QLabel;
class QPushButton;

namespace syncline::ui {

class Card;
class SyncWindowFields;

/// How master and reference clock are brought together, and how closely the slaves are watched.
class SyncStep final : public WizardStep {
  Q_OBJECT

 public:
  explicit SyncStep(MachineDraft& draft);
  ~SyncStep() override;
  [[nodiscard]] QWidget* firstField() const override;
  void refresh() override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void buildShift(Card& card);
  void buildProposal(Card& card);
  void showProposal();

  QButtonGroup* mode_;
  QCheckBox* several_;
  QLabel *proposal_, *meaning_;
  QPushButton* use_;
  std::unique_ptr<SyncWindowFields> window_;
  bool proposed_ = false;
};

}  // namespace syncline::ui
