// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/cycle_step.h"

#include <QLabel>
#include <QVBoxLayout>

#include "advice/cycle_time_help.h"
#include "ui/editors/cycle_field.h"
#include "ui/editors/cycle_table.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/preset_edit.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {
CycleStep::CycleStep(MachineDraft& draft)
    : WizardStep(draft, "wizardCycleStep", tr("Cycle"),
                 tr("How often the process data go over the network. All Sync Unit Cycles are multiples or fractions "
                    "of it.")) {
  auto* area = new QWidget;
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(12);
  auto* card = new Card(tr("Network"));
  fields().text(*card, "masterName", "master.name");
  cycle_ = addCycleField(*this, *card);
  limits_ = card->addValue("wizardCycleLimits", tr("Slaves accept"),
                           tr("What drive families, object 0x1C32:05, operation modes and the frames leave"));
  limits_->setWordWrap(true);
  layout->addWidget(card);
  cycles_ = named(new CycleTable, "wizardCycles", tr("Cycles and who refuses them"));
  connect(cycles_, &CycleTable::cycleTaken, this,
          [this](qint64 cycle) { fields().set("master.cycle_time_us", cycle); });
  layout->addWidget(cycles_, 1);
  setWidget(area);
}

CycleStep::~CycleStep() = default;

QWidget* CycleStep::firstField() const { return cycle_; }

bool CycleStep::keepsEnter() const { return cycles_->hasFocus(); }

void CycleStep::refresh() {
  fields().refresh();
  showCycles();
}

void CycleStep::showCycles() {
  const auto help = cycle_time_help(project());
  if (!help) {
    limits_->setText(noText());
    return cycles_->clearHelp();
  }
  limits_->setText(acceptedCycles(*help));
  cycles_->showHelp(*help);
}

}  // namespace syncline::ui
