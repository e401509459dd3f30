// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/cut_short_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/text/error_text.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

CutShortDialog::CutShortDialog(EepromRepair& repair, QWidget* parent) : QDialog(parent), repair_(repair) {
  setObjectName(QStringLiteral("cutShortDialog"));
  setWindowTitle(tr("EEPROM write was cut short"));
  setMinimumWidth(460);
  auto* layout = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  auto* icon = new QLabel;
  const int size = style()->pixelMetric(QStyle::PM_MessageBoxIconSize, nullptr, this);
  icon->setPixmap(style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(size, size));
  row->addWidget(icon, 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  row->addLayout(words, 1);
  layout->addLayout(row);
  text_ = named(new QLabel, "cutShortText", tr("What was cut short"));
  problem_ = named(new QLabel, "cutShortProblem", tr("Why it could not be ended"));
  for (auto* label : {text_, problem_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(label);
  }
  bar_ = named(new QProgressBar, "cutShortBar", tr("Writing the EEPROM"));
  bar_->setRange(0, 0);
  words->addWidget(bar_);
  auto* buttons = new QDialogButtonBox;
  finish_ = buttons->addButton(tr("&Finish Writing"), QDialogButtonBox::AcceptRole);
  put_back_ = buttons->addButton(tr("&Put Back Old Contents"), QDialogButtonBox::ActionRole);
  later_ = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
  named(finish_, "cutShortFinish", tr("Finish writing"));
  named(put_back_, "cutShortPutBack", tr("Put back old contents"));
  named(later_, "cutShortLater", tr("Later"));
  layout->addWidget(buttons);
  connect(finish_, &QPushButton::clicked, this, [this] { work(false); });
  connect(put_back_, &QPushButton::clicked, this, [this] { work(true); });
  connect(later_, &QPushButton::clicked, this, &CutShortDialog::reject);
  connect(&repair, &EepromRepair::finished, this, &CutShortDialog::onFinished);
  connect(&repair, &EepromRepair::failed, this, &CutShortDialog::onFailed);
  setBusy(false);
}

void CutShortDialog::offer() {
  writes_ = repair_.pending();
  if (writes_.empty()) return;
  showFirst();
  open();
}

void CutShortDialog::showFirst() {
  const auto& write = writes_.front();
  auto text = tr("Writing the EEPROM of slave %1 on %2 was cut short (begun %3 UTC). What it holds now is half old and "
                 "half new: "
                 "the slave may not start after its next power-on. Connect it and end the write.")
                  .arg(write.position)
                  .arg(write.link, write.begun);
  if (writes_.size() > 1)
    text += QLatin1Char(' ') + tr("%n more write(s) follow.", nullptr, static_cast<int>(writes_.size()) - 1);
  text_->setText(text);
  problem_->clear();
  problem_->hide();
  fit();
}

void CutShortDialog::work(bool undo) {
  if (writes_.empty() || repair_.isRunning()) return;
  undo_ = undo;
  problem_->hide();
  setBusy(true);
  repair_.start(writes_.front(), undo);
}

void CutShortDialog::setBusy(bool busy) {
  bar_->setVisible(busy);
  finish_->setEnabled(!busy);
  put_back_->setEnabled(!busy);
  finish_->setDefault(true);
  later_->setText(busy ? tr("&Cancel") : tr("&Later"));
}

void CutShortDialog::onFinished() {
  setBusy(false);
  const auto& write = writes_.front();
  Q_EMIT told((undo_ ? tr("The EEPROM of slave %1 on %2 holds its old contents again.")
                     : tr("The EEPROM of slave %1 on %2 is written and verified."))
                  .arg(write.position)
                  .arg(write.link));
  writes_.erase(writes_.begin());
  if (writes_.empty()) return accept();
  showFirst();
}

void CutShortDialog::onFailed(const Error& error) {
  setBusy(false);
  problem_->setText(errorText(error));
  problem_->show();
  fit();
}

/// As high as its words: a dialog does not grow of itself when a label in it wraps more lines.
void CutShortDialog::fit() {
  layout()->activate();
  resize(width(), std::max(height(), layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width())
                                                                   : sizeHint().height()));
}

void CutShortDialog::reject() {
  if (repair_.isRunning()) return repair_.cancel();
  for (const auto& write : writes_) {
    Q_EMIT told(tr("The EEPROM of slave %1 on %2 is still half written; the next start offers to end it.")
                    .arg(write.position)
                    .arg(write.link));
  }
  QDialog::reject();
}

}  // namespace syncline::ui
