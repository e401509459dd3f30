// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/wizard/wizard_step.h"

class QButtonGroup;
class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace syncline::ui {

/// Where the slaves come from: a scan, an ENI, the device catalogue, or a project as a pattern.
class SourceStep final : public WizardStep {
  Q_OBJECT

 public:
  explicit SourceStep(MachineDraft& draft);
  [[nodiscard]] QString whyNotOn() const override;
  [[nodiscard]] bool keepsEnter() const override;
  [[nodiscard]] QWidget* firstField() const override;
  void refresh() override;

 private:
  QWidget* buildSources();
  QWidget* buildScan();
  QWidget* buildCatalogue();
  QWidget* buildFile(const char* object_name, const QString& text, const QString& button, void (SourceStep::*choose)());
  QWidget* buildTemplates();
  QWidget* buildSlaves();
  void chooseBus();
  void chooseEni();
  void chooseProject();
  void removeSelected();
  void showScan();
  void showTemplates();
  void takeTemplate();
  void removeChosenTemplate();

  QButtonGroup* sources_;
  QStackedWidget* stack_;
  QPushButton *scan_, *cancel_, *fully_, *remove_;
  QLabel *bus_, *looked_, *told_, *count_;
  QListWidget *slaves_, *templates_;
  QPushButton *use_template_, *remove_template_;
};

}  // namespace syncline::ui
