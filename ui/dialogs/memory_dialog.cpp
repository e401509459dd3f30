// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/memory_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/session/workspace.h"
#include "ui/text/recorded_text.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

MemoryDialog::MemoryDialog(Workspace& workspace, QWidget* parent) : QDialog(parent), workspace_(workspace) {
  setObjectName(QStringLiteral("memoryDialog"));
  setWindowTitle(tr("Memory for the Last Cycles"));
  setMinimumWidth(460);
  auto* layout = new QVBoxLayout(this);
  auto* words = new QLabel(
      tr("Every cycle of a run is kept in memory, so that the last stretch can be saved afterwards. The oldest go "
         "when the memory is full."));
  words->setWordWrap(true);
  layout->addWidget(words);
  auto* form = new QFormLayout;
  mib_ = named(new QSpinBox, "memoryMib", tr("Memory for each network"));
  mib_->setRange(1, DiskRecording::kMostMemoryMib);
  mib_->setSuffix(QStringLiteral(" MiB"));
  mib_->setValue(workspace.runs().memoryMib());
  form->addRow(tr("&Memory for each network"), mib_);
  layout->addLayout(form);
  reach_ = named(new QLabel, "memoryReach", tr("How much time it holds"));
  loss_ = named(new QLabel, "memoryLoss", tr("What is forgotten at once"));
  for (auto* label : {reach_, loss_}) {
    label->setWordWrap(true);
    layout->addWidget(label);
  }
  layout->addStretch();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  named(buttons->button(QDialogButtonBox::Ok), "memoryAccept", tr("OK"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(mib_, &QSpinBox::valueChanged, this, &MemoryDialog::refresh);
  refresh();
}

void MemoryDialog::refresh() {
  const auto& disk = workspace_.disk();
  const auto reach = disk.memoryReach(mib_->value());
  reach_->setText(reach == 0 ? tr("How much time that is follows from the cycle time: nothing has run yet.")
                             : tr("Holds every cycle of about the last %1 of this network.").arg(spanText(reach)));
  const bool loses = reach > 0 && disk.remembered() > reach;
  loss_->setText(
      loses ? tr("The last %1 are in memory: what is older than that goes at once.").arg(spanText(disk.remembered()))
            : QString());
}

void MemoryDialog::accept() {
  workspace_.setMemoryMib(mib_->value());
  QDialog::accept();
}

}  // namespace syncline::ui
