// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/cycle_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "advice/cycle_time_help.h"
#include "config/project.h"
#include "ui/editors/cycle_table.h"
#include "ui/text/error_text.h"
#include "ui/text/finding_text.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

CycleDialog::CycleDialog(const Project& project, QWidget* parent) : QDialog(parent), own_(project.master.cycle_time) {
  setObjectName(QStringLiteral("cycleDialog"));
  setWindowTitle(tr("Cycle Times"));
  auto* layout = new QVBoxLayout(this);
  auto* accepted = new QLabel;
  accepted->setObjectName(QStringLiteral("cycleDialogAccepted"));
  accepted->setWordWrap(true);
  layout->addWidget(accepted);
  table_ = named(new CycleTable, "cycleDialogTable", tr("Cycles and who refuses them"));
  layout->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  use_ = buttons->addButton(tr("&Use This Cycle"), QDialogButtonBox::AcceptRole);
  use_->setObjectName(QStringLiteral("cycleDialogUse"));
  layout->addWidget(buttons);
  connect(table_, &CycleTable::cycleTaken, this, &CycleDialog::take);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto cycle = table_->markedCycle();
    use_->setEnabled(cycle > 0 && cycle != own_);
  });
  connect(buttons, &QDialogButtonBox::accepted, this, [this] { take(table_->markedCycle()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  use_->setEnabled(false);
  if (const auto help = cycle_time_help(project)) {
    accepted->setText(tr("The slaves accept: %1.").arg(acceptedCycles(*help)));
    table_->showHelp(*help);
  } else {
    accepted->setText(errorText(help.error()));
  }
  resize(760, 520);
}

void CycleDialog::take(qint64 cycle) {
  if (cycle <= 0) return;
  taken_ = cycle;
  accept();
}

}  // namespace syncline::ui
