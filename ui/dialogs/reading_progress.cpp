// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/reading_progress.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProgressDialog>
#include <utility>

#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kWhole = 1000, kPatienceMs = 300;

struct ReadingProgressText {
  Q_DECLARE_TR_FUNCTIONS(ReadingProgress)
};

}  // namespace

void ReadingProgress::begin(const QString& path, const char* name, const QString& title, std::function<void()> cancel) {
  end();
  dialog_ = named(new QProgressDialog(ReadingProgressText::tr("Reading %1…").arg(QFileInfo(path).fileName()),
                                      ReadingProgressText::tr("Cancel"), 0, kWhole, &window_),
                  name, title);
  dialog_->setWindowTitle(title);
  dialog_->setWindowModality(Qt::WindowModal);
  dialog_->setAutoClose(false);
  dialog_->setAutoReset(false);
  dialog_->setMinimumDuration(kPatienceMs);
  QObject::connect(dialog_, &QProgressDialog::canceled, dialog_, std::move(cancel));
}

void ReadingProgress::set(int permille) {
  if (dialog_) dialog_->setValue(permille);
}

void ReadingProgress::end() {
  if (!dialog_) return;
  dialog_->hide();
  dialog_->deleteLater();
}

}  // namespace syncline::ui
