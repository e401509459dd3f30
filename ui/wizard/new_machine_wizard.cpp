// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/new_machine_wizard.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/dialogs/questions.h"
#include "ui/editors/field_binder.h"
#include "ui/widgets/named.h"
#include "ui/wizard/clock_step.h"
#include "ui/wizard/cycle_step.h"
#include "ui/wizard/machine_draft.h"
#include "ui/wizard/modes_step.h"
#include "ui/wizard/source_step.h"
#include "ui/wizard/summary_step.h"
#include "ui/wizard/sync_step.h"

namespace syncline::ui {

NewMachineWizard::NewMachineWizard(Workspace& workspace, QWidget* parent)
    : QDialog(parent), draft_(new MachineDraft(workspace, this)) {
  setObjectName(QStringLiteral("newMachineWizard"));
  setWindowTitle(tr("New Machine"));
  resize(960, 590);
  summary_ = new SummaryStep(*draft_);
  steps_ = {new SourceStep(*draft_), new CycleStep(*draft_), new ClockStep(*draft_),
            new SyncStep(*draft_),   new ModesStep(*draft_), summary_};
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(10);
  buildHead(*layout);
  stack_ = new QStackedWidget;
  for (auto* step : steps_) {
    stack_->addWidget(step);
    step->setNode(-1);
  }
  layout->addWidget(stack_, 1);
  buildFoot(*layout);
  auto& own = draft_->workspace();
  connect(&own.document(), &ProjectDocument::projectChanged, this, &NewMachineWizard::showState);
  connect(&own.configuration(), &ConfigurationMonitor::compiled, this, &NewMachineWizard::showState);
  connect(draft_, &MachineDraft::scanChanged, this, &NewMachineWizard::showState);
  goTo(0);
}

/// The way through the steps, with the present one in front.
void NewMachineWizard::buildHead(QVBoxLayout& layout) {
  auto* way = new QHBoxLayout;
  way->setSpacing(14);
  for (int i = 0; i < static_cast<int>(steps_.size()); ++i) {
    auto* name = new QLabel(QStringLiteral("%1  %2").arg(i + 1).arg(steps_[i]->title()));
    name->setObjectName(QStringLiteral("wizardWay%1").arg(i));
    names_.append(name);
    way->addWidget(name);
  }
  way->addStretch(1);
  layout.addLayout(way);
  title_ = named(new QLabel, "wizardTitle", tr("Step"));
  auto font = title_->font();
  font.setPointSizeF(font.pointSizeF() * 1.35);
  font.setWeight(QFont::DemiBold);
  title_->setFont(font);
  layout.addWidget(title_);
  explanation_ = named(new QLabel, "wizardExplanation", tr("What is decided here"));
  explanation_->setWordWrap(true);
  layout.addWidget(explanation_);
}

void NewMachineWizard::buildFoot(QVBoxLayout& layout) {
  auto* foot = new QHBoxLayout;
  obstacle_ = named(new QLabel, "wizardObstacle", tr("Why it does not go on"));
  obstacle_->setWordWrap(true);
  foot->addWidget(obstacle_, 1);
  back_ = named(new QPushButton(tr("< Bac&k")), "wizardBack", tr("Back"));
  next_ = named(new QPushButton, "wizardNext", tr("Next"));
  cancel_ = named(new QPushButton(tr("Cancel")), "wizardCancel", tr("Cancel"));
  for (auto* button : {back_, next_, cancel_}) {
    button->setAutoDefault(false);
    foot->addWidget(button);
  }
  next_->setDefault(true);
  connect(back_, &QPushButton::clicked, this, &NewMachineWizard::back);
  connect(next_, &QPushButton::clicked, this, &NewMachineWizard::next);
  connect(cancel_, &QPushButton::clicked, this, &NewMachineWizard::reject);
  layout.addLayout(foot);
}

int NewMachineWizard::step() const { return stack_->currentIndex(); }

WizardStep& NewMachineWizard::current() const { return *steps_[step()]; }

void NewMachineWizard::goTo(int step) {
  stack_->setCurrentIndex(step);
  for (int i = 0; i < static_cast<int>(names_.size()); ++i) {
    auto font = names_[i]->font();
    font.setBold(i == step);
    names_[i]->setFont(font);
    names_[i]->setForegroundRole(i == step ? QPalette::WindowText : QPalette::PlaceholderText);
  }
  const bool last = step + 1 == static_cast<int>(steps_.size());
  title_->setText(current().title());
  explanation_->setText(current().explanation());
  next_->setText(last ? tr("&Finish") : tr("&Next >"));
  next_->setAccessibleName(last ? tr("Finish") : tr("Next"));
  back_->setEnabled(step > 0);
  obstacle_->clear();
  showState();
  current().firstField()->setFocus(Qt::TabFocusReason);
}

void NewMachineWizard::showState() {
  const auto& result = draft_->workspace().configuration().current();
  current().showDraft(result ? result->findings : std::vector<Finding>{});
  const bool scanning = draft_->isScanning();
  next_->setEnabled(!scanning);
  if (!obstacle_->text().isEmpty()) obstacle_->setText(current().whyNotOn());
}

void NewMachineWizard::back() {
  if (!current().fields().commit()) current().fields().revert();
  if (step() > 0) goTo(step() - 1);
}

void NewMachineWizard::next() {
  if (!current().fields().commit())
    return obstacle_->setText(tr("A field holds what cannot be a value: mend it, or press Esc in it."));
  if (const auto why = current().whyNotOn(); !why.isEmpty()) return obstacle_->setText(why);
  if (step() + 1 < static_cast<int>(steps_.size())) return goTo(step() + 1);
  const auto path = summary_->exportPath();
  if (!path.isEmpty() && QFileInfo::exists(path) &&
      !ask(*this, "overwriteQuestion", tr("%1 exists already.").arg(QFileInfo(path).fileName()),
           tr("Its contents go when the ENI is written."), tr("Overwrite"))) {
    return;
  }
  Q_EMIT taken(draft_->machine(), draft_->link(), path);
}

void NewMachineWizard::reject() {
  if (!draft_->project().slaves.empty() &&
      !ask(*this, "wizardQuestion", tr("Give up the new machine?"),
           tr("What was chosen here goes. The project of the window stays as it is."), tr("Give Up"))) {
    return;
  }
  draft_->cancelScan();
  QDialog::reject();
}

/// Enter in a list or a search is for these; everywhere else it leads on.
void NewMachineWizard::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && current().keepsEnter()) return event->accept();
  QDialog::keyPressEvent(event);
}

}  // namespace syncline::ui
