// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/scan_progress.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

#include "ui/session/scan_controller.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

ScanProgress::ScanProgress(ScanController& scan, QWidget* parent) : QDialog(parent), scan_(scan) {
  setObjectName(QStringLiteral("scanProgress"));
  setWindowTitle(tr("Scan"));
  setModal(true);
  setMinimumWidth(380);
  auto* layout = new QVBoxLayout(this);
  text_ = named(new QLabel, "scanText", tr("Scan progress"));
  layout->addWidget(text_);
  bar_ = named(new QProgressBar, "scanBar", tr("Scan progress"));
  layout->addWidget(bar_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::rejected, this, &ScanProgress::reject);
  layout->addWidget(buttons);
  connect(&scan, &ScanController::started, this, [this] {
    text_->setText(tr("Looking for slaves…"));
    bar_->setRange(0, 0);
    open();
  });
  connect(&scan, &ScanController::progress, this, [this](int done, int found) {
    text_->setText(tr("Reading slave %1 of %2").arg(done).arg(found));
    bar_->setRange(0, found);
    bar_->setValue(done);
  });
  connect(&scan, &ScanController::finished, this, [this] { done(QDialog::Accepted); });
  connect(&scan, &ScanController::failed, this, [this] { done(QDialog::Rejected); });
}

void ScanProgress::reject() {
  text_->setText(tr("Cancelling…"));
  scan_.cancel();
}

}  // namespace syncline::ui
