// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/modes_step.h"

#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "settings/settings_table.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/wizard/dc_mode_delegate.h"
#include "ui/wizard/dc_mode_model.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {

ModesStep::ModesStep(MachineDraft& draft)
    : WizardStep(
          draft, "wizardModesStep", tr("Operation Modes"),
          tr("What each slave does with the SYNC signals, and how often. F2 or a double click opens a choice.")) {
  auto* area = new QWidget;
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  model_ = new DcModeModel(
      draft.project(),
      [this](const char* key, const settings::Place& place, const settings::Value& value) {
        std::vector<SettingEdit> edits{{&settings::row(key), place, value}};
        // A factor replaces a cycle of the user's own.
        if (qstrcmp(key, "slave.N.dc.sync0.factor") == 0)
          edits.push_back({&settings::row("slave.N.dc.sync0.cycle_us"), place, {}});
        note_->clear();
        return set(tr("Change DC mode"), std::move(edits));
      },
      this);
  table_ = named(new QTableView, "wizardModes", tr("Operation modes of all slaves"));
  setUpTable(*table_);
  table_->setModel(model_);
  table_->setItemDelegate(new DcModeDelegate(table_));
  table_->setSelectionBehavior(QAbstractItemView::SelectItems);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::SelectedClicked);
  table_->setTabKeyNavigation(false);
  table_->setColumnWidth(DcModeModel::kSlave, 190);
  table_->setColumnWidth(DcModeModel::kMode, 170);
  table_->setColumnWidth(DcModeModel::kFactor, 190);
  table_->setColumnWidth(DcModeModel::kCycle, 90);
  stretchColumn(*table_, DcModeModel::kNote);
  layout->addWidget(table_, 1);
  note_ = named(new QLabel, "wizardModesNote", tr("What is found wrong with the selected slave"));
  note_->setWordWrap(true);
  note_->setTextFormat(Qt::PlainText);
  layout->addWidget(note_);
  setWidget(area);
  connect(model_, &DcModeModel::refused, note_, &QLabel::setText);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& now) {
    note_->setText(now.siblingAtColumn(DcModeModel::kNote).data().toString());
  });
}

ModesStep::~ModesStep() = default;

QWidget* ModesStep::firstField() const { return table_; }

bool ModesStep::keepsEnter() const { return table_->isAncestorOf(window()->focusWidget()); }

void ModesStep::refresh() {
  const auto& result = workspace().configuration().result();
  model_->refresh(result ? result->findings : std::vector<Finding>{});
  const auto now = table_->currentIndex();
  if (!now.isValid() && model_->rowCount() > 0) return table_->setCurrentIndex(model_->index(0, DcModeModel::kMode));
  note_->setText(now.siblingAtColumn(DcModeModel::kNote).data().toString());
}

}  // namespace syncline::ui
