// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/sync_step.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "advice/shift_proposal.h"
#include "settings/settings_table.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/sync_window_fields.h"
#include "ui/text/setting_text.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {
namespace {

constexpr const char* kMode = "master.dc.mode";

QString meaningOf(DcmMode mode) {
  switch (mode) {
    case DcmMode::kBusShift:
      return SyncStep::tr(
          "The master's clock leads and steers the reference clock, by a command in each frame. For several networks "
          "in one machine, or a host whose timer cannot be moved. It needs a steady host.");
    case DcmMode::kMasterShift:
      return SyncStep::tr(
          "The reference clock leads and the master moves its send time after it. For one network; the slaves' SYNC "
          "signals have nothing of the host's jitter.");
    case DcmMode::kOff:
      return SyncStep::tr(
          "Nobody follows: the frames drift through the SYNC grid of the slaves. For machines without synchronised "
          "motion only.");
    default:
      return SyncStep::tr("Another way, for special hardware; the page Distributed Clocks of the master explains it.");
  }
}

QString reasonOfProposal(ShiftReason reason) {
  switch (reason) {
    case ShiftReason::kClocksOff:
      return SyncStep::tr("Distributed clocks are off: there is nothing to bring together.");
    case ShiftReason::kNobodyUsesThem:
      return SyncStep::tr("No slave has an operation mode with SYNC signals: there is nothing to bring together.");
    case ShiftReason::kSeveralNetworks:
      return SyncStep::tr("Networks keep step when each reference clock follows the one clock of the masters.");
    case ShiftReason::kOneNetwork:
      return SyncStep::tr("In a single network the slave's clock is the steadiest one to follow.");
  }
  return {};
}

QLabel* sentenceLabel(const char* object_name, const QString& accessible_name) {
  auto* label = named(new QLabel, object_name, accessible_name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

SyncStep::SyncStep(MachineDraft& draft)
    : WizardStep(draft, "wizardSyncStep", tr("Synchronisation"),
                 tr("Master and reference clock run at slightly different speeds: one of them has to follow the "
                    "other.")) {
  auto* columns = new CardColumns;
  buildShift(*columns->add(0, tr("Who follows whom")));
  buildProposal(*columns->add(1, tr("Proposal")));
  window_ = std::make_unique<SyncWindowFields>(*this, *columns->add(1, tr("Sync Window Monitoring")));
  columns->addStretch();
  setWidget(columns);
}

SyncStep::~SyncStep() = default;

void SyncStep::buildShift(Card& card) {
  mode_ = fields().buttons(card, kMode,
                           {{static_cast<std::int64_t>(DcmMode::kMasterShift), "dcmMasterShift"},
                            {static_cast<std::int64_t>(DcmMode::kBusShift), "dcmBusShift"},
                            {static_cast<std::int64_t>(DcmMode::kOff), "dcmOff"}},
                           3);
  for (auto* button : mode_->buttons()) button->setToolTip(meaningOf(static_cast<DcmMode>(mode_->id(button))));
  meaning_ = sentenceLabel("wizardMeaning", tr("What it is for"));
  card.addWide(meaning_);
}

void SyncStep::buildProposal(Card& card) {
  several_ =
      named(new QCheckBox(tr("&Several networks run in step")), "wizardSeveral", tr("Several networks run in step"));
  several_->setToolTip(tr("More than one EtherCAT network of the machine has to keep a common time"));
  card.addWide(several_);
  proposal_ = sentenceLabel("wizardProposal", tr("Proposal"));
  card.addWide(proposal_);
  use_ = named(new QPushButton(tr("&Use Proposal")), "wizardUseProposal", tr("Use the proposal"));
  use_->setAutoDefault(false);
  card.addWide(use_);
  connect(several_, &QCheckBox::toggled, this, &SyncStep::showProposal);
  connect(use_, &QPushButton::clicked, this, [this] {
    fields().set(kMode, static_cast<std::int64_t>(propose_shift(project(), several_->isChecked()).mode));
  });
}

QWidget* SyncStep::firstField() const {
  auto* checked = mode_->checkedButton();
  return checked != nullptr ? checked : mode_->buttons().front();
}

/// A new machine has what is proposed for it, and is watched; whoever has seen that may say it otherwise.
void SyncStep::showEvent(QShowEvent* event) {
  WizardStep::showEvent(event);
  if (draft().masterIsGiven() || !project().master.dc.enabled || std::exchange(proposed_, true)) return;
  const auto mode = propose_shift(project(), false).mode;
  const settings::Place master;
  set(tr("Use the proposal"), {{&settings::row(kMode), master, static_cast<std::int64_t>(mode)},
                               {&settings::row("master.dc.sync_window"), master, mode != DcmMode::kOff}});
}

void SyncStep::refresh() {
  const auto& dc = project().master.dc;
  fields().refresh();
  for (auto* button : mode_->buttons()) button->setEnabled(dc.enabled);
  window_->show(dc);
  meaning_->setText(meaningOf(dc.dcm.mode));
  showProposal();
}

void SyncStep::showProposal() {
  const auto [mode, reason] = propose_shift(project(), several_->isChecked());
  const auto* button = mode_->button(static_cast<int>(mode));
  const auto name = button != nullptr ? button->text() : QString();
  proposal_->setText(QStringLiteral("%1: %2").arg(name, reasonOfProposal(reason)));
  use_->setEnabled(project().master.dc.enabled && project().master.dc.dcm.mode != mode);
}

}  // namespace syncline::ui
