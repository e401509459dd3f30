// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/clock_step.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "advice/clock_candidates.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {
namespace {

enum ClockColumn : int { kSlave, kCanLead, kWhy, kClockColumns };

QString reasonOf(const ClockCandidate& candidate, const Project& project) {
  switch (candidate.concern) {
    case ClockConcern::kNone:
      return {};
    case ClockConcern::kNoClock:
      return ClockStep::tr("Its description has no distributed clocks.");
    case ClockConcern::kMayBeMissing:
      return ClockStep::tr("It may be missing; then nobody leads.");
    case ClockConcern::kBehindFollower:
      return ClockStep::tr("%1 stands before it, uses DC and would hear of its time a cycle late.")
          .arg(QString::fromStdString(project.slaves[candidate.follower].name));
  }
  return {};
}

QString verdictOn(const ClockCandidate& candidate) {
  if (!candidate.capable()) return ClockStep::tr("No");
  return candidate.concern == ClockConcern::kNone ? ClockStep::tr("Yes") : ClockStep::tr("Better not");
}

}  // namespace

ClockStep::ClockStep(MachineDraft& draft)
    : WizardStep(draft, "wizardClockStep", tr("Reference Clock"),
                 tr("Slaves that move together need distributed clocks: one slave's clock leads, and the others follow "
                    "it. Without synchronised motion leave them off.")) {
  auto* area = new QWidget;
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(12);
  auto* card = new Card(tr("Distributed Clocks"));
  enabled_ = fields().toggle(*card, "dcEnabled", "master.dc.enabled");
  reference_ = fields().choice(*card, "referenceClock", "master.dc.reference_clock");
  leader_ =
      card->addValue("wizardLeader", tr("Leads now"), tr("The slave whose clock the compiled project makes lead"));
  layout->addWidget(card);
  candidates_ = named(new QTableWidget(0, kClockColumns), "wizardClocks", tr("Which slaves can lead, and why not"));
  setUpTable(*candidates_);
  candidates_->setHorizontalHeaderLabels({tr("Slave"), tr("Can lead"), tr("Why not")});
  candidates_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  candidates_->setColumnWidth(kSlave, 230);
  candidates_->setColumnWidth(kCanLead, 130);
  stretchColumn(*candidates_, kWhy);
  layout->addWidget(candidates_, 1);
  setWidget(area);
}

ClockStep::~ClockStep() = default;

QWidget* ClockStep::firstField() const { return enabled_; }

void ClockStep::refresh() {
  fields().refresh();
  reference_->setEnabled(project().master.dc.enabled);
  const auto* config = workspace().configuration().config();
  leader_->setText(noText());
  if (config != nullptr) {
    const auto found = std::ranges::find_if(
        config->slaves, [](const SlaveConfig& slave) { return slave.dc && slave.dc->reference_clock; });
    if (found != config->slaves.end()) leader_->setText(QString::fromStdString(found->name));
  }
  showCandidates();
}

void ClockStep::showCandidates() {
  const auto candidates = clock_candidates(project());
  candidates_->setRowCount(static_cast<int>(candidates.size()));
  for (int i = 0; i < candidates_->rowCount(); ++i) {
    const auto& candidate = candidates[static_cast<std::size_t>(i)];
    const auto& slave = project().slaves[static_cast<std::size_t>(i)];
    candidates_->setItem(i, kSlave,
                         new QTableWidgetItem(QStringLiteral("%1  %2").arg(i).arg(QString::fromStdString(slave.name))));
    candidates_->setItem(i, kCanLead, new QTableWidgetItem(verdictOn(candidate)));
    auto* why = new QTableWidgetItem(reasonOf(candidate, project()));
    why->setToolTip(why->text());
    candidates_->setItem(i, kWhy, why);
  }
  if (candidates_->currentRow() < 0 && candidates_->rowCount() > 0) candidates_->setCurrentCell(0, 0);
}

}  // namespace syncline::ui
