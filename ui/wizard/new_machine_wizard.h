// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QList>

#include "config/project.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace syncline::ui {

class MachineDraft;
class SummaryStep;
class WizardStep;
class Workspace;

/// Makes a machine step by step: slaves, cycle, reference clock, synchronisation, operation modes, summary. All of it
/// is a draft beside the window's project until taken() says that the user has finished.
class NewMachineWizard final : public QDialog {
  Q_OBJECT

 public:
  explicit NewMachineWizard(Workspace& workspace, QWidget* parent);

  /// Position of the step that is shown.
  [[nodiscard]] int step() const;
  [[nodiscard]] MachineDraft& draft() { return *draft_; }

  /// Asks when there is something to lose.
  void reject() override;

 Q_SIGNALS:
  /// Finished: the machine, the LINK that was scanned ("" = none) and where its ENI is wanted ("" = nowhere). The
  /// receiver calls accept() when it took it.
  void taken(const syncline::Machine& machine, const QString& link, const QString& eni_path);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void buildHead(QVBoxLayout& layout);
  void buildFoot(QVBoxLayout& layout);
  void goTo(int step);
  void next();
  void back();
  [[nodiscard]] WizardStep& current() const;
  void showState();

  MachineDraft* draft_;
  QList<WizardStep*> steps_;
  SummaryStep* summary_;
  QList<QLabel*> names_;
  QLabel *title_, *explanation_, *obstacle_;
  QStackedWidget* stack_;
  QPushButton *back_, *next_, *cancel_;
};

}  // namespace syncline::ui
