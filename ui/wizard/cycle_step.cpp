// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/cycle_step.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "advice/cycle_time_help.h"
#include "settings/settings_table.h"
#include "ui/editors/cycle_field.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/preset_edit.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {
namespace {

enum CycleColumn : int { kCycle, kVerdict, kBy, kCycleColumns };

/// Those who refuse a cycle, or take it with a loss; each once.
QString namesOf(const CycleCandidate& candidate, bool partly) {
  QStringList names;
  for (const auto& refusal : candidate.refusals) {
    if (refusal.partly != partly) continue;
    const auto name = refusal.slave < 0 ? CycleStep::tr("the frames") : QString::fromStdString(refusal.name);
    if (!names.contains(name)) names << name;
  }
  return joinedParts(names);
}

QString verdictOf(const CycleCandidate& candidate) {
  if (!candidate.accepted()) return CycleStep::tr("Refused");
  return candidate.refusals.empty() ? CycleStep::tr("Accepted by all") : CycleStep::tr("Taken with a loss");
}

}  // namespace

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
  cycles_ = named(new QTableWidget(0, kCycleColumns), "wizardCycles", tr("Cycles and who refuses them"));
  setUpTable(*cycles_);
  cycles_->setHorizontalHeaderLabels({tr("Cycle"), tr("Slaves"), tr("Because of")});
  cycles_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  cycles_->setColumnWidth(kCycle, 110);
  cycles_->setColumnWidth(kVerdict, 170);
  stretchColumn(*cycles_, kBy);
  cycles_->setToolTip(tr("Enter or a double click takes the cycle"));
  connect(cycles_, &QTableWidget::activated, this, &CycleStep::takeSelected);
  layout->addWidget(cycles_, 1);
  setWidget(area);
}

CycleStep::~CycleStep() = default;

QWidget* CycleStep::firstField() const { return cycle_; }

bool CycleStep::keepsEnter() const { return cycles_->hasFocus(); }

void CycleStep::takeSelected() {
  const auto* item = cycles_->item(cycles_->currentRow(), kCycle);
  if (item != nullptr) fields().set("master.cycle_time_us", item->data(Qt::UserRole).toLongLong());
}

void CycleStep::refresh() {
  fields().refresh();
  showCycles();
}

void CycleStep::showCycles() {
  const auto help = cycle_time_help(project());
  if (!help) {
    limits_->setText(noText());
    return cycles_->setRowCount(0);
  }
  const auto shortest = help->shortest ? cycleText(*help->shortest) : noText();
  const auto longest = help->longest ? cycleText(*help->longest) : noText();
  limits_->setText(help->shortest || help->longest || help->step > 1
                       ? tr("%1 to %2, in steps of %3").arg(shortest, longest, cycleText(help->step))
                       : tr("any cycle"));
  const int row = cycles_->currentRow();
  cycles_->setRowCount(static_cast<int>(help->candidates.size()));
  for (int i = 0; i < cycles_->rowCount(); ++i) {
    const auto& candidate = help->candidates[static_cast<std::size_t>(i)];
    auto* cycle = new QTableWidgetItem(cycleText(candidate.cycle));
    cycle->setData(Qt::UserRole, static_cast<qlonglong>(candidate.cycle));
    auto font = cycle->font();
    font.setBold(candidate.cycle == project().master.cycle_time);
    cycle->setFont(font);
    cycles_->setItem(i, kCycle, cycle);
    cycles_->setItem(i, kVerdict, new QTableWidgetItem(verdictOf(candidate)));
    auto* by = new QTableWidgetItem(namesOf(candidate, candidate.accepted()));
    by->setToolTip(by->text());
    cycles_->setItem(i, kBy, by);
    if (cycle->font().bold() && row < 0) cycles_->setCurrentItem(cycle);
  }
}

}  // namespace syncline::ui
