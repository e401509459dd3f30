// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/recovery_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/dialogs/questions.h"
#include "ui/session/autosave.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

RecoveryDialog::RecoveryDialog(Autosave& autosave, std::vector<LostWork> lost, QWidget* parent)
    : QDialog(parent), autosave_(autosave), lost_(std::move(lost)) {
  setObjectName(QStringLiteral("recoveryDialog"));
  setWindowTitle(tr("Recover Unsaved Work"));
  setMinimumSize(560, 300);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(10);
  auto* text = new QLabel(
      tr("A window ended before its edits were saved. They were kept; the files themselves are as they were last "
         "saved."));
  text->setWordWrap(true);
  layout->addWidget(text);
  list_ = named(new QListWidget, "recoveryList", tr("Unsaved work"));
  list_->setIconSize(QSize(24, 24));
  list_->setSpacing(2);
  layout->addWidget(list_, 1);
  auto* buttons = new QDialogButtonBox;
  auto* recover = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
  auto* later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
  auto* away = buttons->addButton(tr("&Discard…"), QDialogButtonBox::DestructiveRole);
  named(recover, "recoveryRecover", tr("Recover"));
  named(later, "recoveryLater", tr("Later"))->setToolTip(tr("Leaves it to the next start"));
  named(away, "recoveryDiscard", tr("Discard"));
  recover->setDefault(true);
  layout->addWidget(buttons);
  const auto take = [this] {
    if (list_->currentRow() < 0) return;
    const auto work = lost_[static_cast<std::size_t>(list_->currentRow())];
    accept();
    Q_EMIT wanted(work);
  };
  connect(recover, &QPushButton::clicked, this, take);
  connect(list_, &QListWidget::itemActivated, this, take);
  connect(later, &QPushButton::clicked, this, &QDialog::reject);
  connect(away, &QPushButton::clicked, this, &RecoveryDialog::discard);
  fill();
}

void RecoveryDialog::fill() {
  list_->clear();
  for (const auto& [file, work] : lost_) {
    const auto name = work.path.isEmpty() ? tr("Untitled") : QFileInfo(work.path).fileName();
    auto detail =
        tr("kept %1, %n slave(s)", nullptr, work.slaves).arg(QLocale().toString(work.saved, QLocale::ShortFormat));
    if (!work.last_edit.isEmpty()) detail += tr(", last edit: %1").arg(work.last_edit);
    auto* item = new QListWidgetItem(theme::icon(QStringLiteral("save"), palette()),
                                     QStringLiteral("%1\n%2").arg(name, detail), list_);
    item->setData(Qt::AccessibleTextRole, QStringLiteral("%1, %2").arg(name, detail));
    item->setToolTip(work.path.isEmpty() ? tr("Never saved") : work.path);
  }
  list_->setCurrentRow(0);
}

void RecoveryDialog::discard() {
  const int row = list_->currentRow();
  if (row < 0) return;
  const auto place = lost_.begin() + row;
  if (!ask(*this, "discardQuestion", tr("Discard this work for good?"), list_->currentItem()->text(), tr("Discard"))) {
    return;
  }
  autosave_.discard(*place);
  lost_.erase(place);
  if (lost_.empty()) return reject();
  fill();
}

}  // namespace syncline::ui
