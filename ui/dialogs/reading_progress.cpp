// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/reading_progress.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLabel>
#include <QProgressDialog>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kWhole = 1000, kPatienceMs = 300;
constexpr double kOfWindow = 0.7;
constexpr int kLeastWidth = 560, kLeastHeight = 300;

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

/// The dialog lays out a label, whatever that holds.
void ReadingProgress::show(QWidget* picture) {
  if (!dialog_) return delete picture;
  auto* words = new QLabel(dialog_->labelText());
  auto* room = new QLabel;
  auto* layout = new QVBoxLayout(room);
  // The dialog keeps a margin beside it, and none above.
  layout->setContentsMargins(0, layout->contentsMargins().top(), 0, layout->contentsMargins().bottom());
  layout->addWidget(words);
  layout->addWidget(picture, 1);
  auto* rest = new QLabel(
      ReadingProgressText::tr("Single slaves, counts, figures and events are shown as soon as all of it is read."));
  rest->setWordWrap(true);
  layout->addWidget(rest);
  dialog_->setLabel(room);
  const auto wanted = window_.size() * kOfWindow;
  dialog_->resize(std::max(wanted.width(), kLeastWidth), std::max(wanted.height(), kLeastHeight));
  dialog_->show();
}

void ReadingProgress::end() {
  if (!dialog_) return;
  dialog_->hide();
  dialog_->deleteLater();
}

}  // namespace syncline::ui
