// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/black_box_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/session/workspace.h"
#include "ui/text/black_box_text.h"
#include "ui/text/recorded_text.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kStateInterval = 500;  // ms

QString usualFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
      .filePath(QStringLiteral("syncline-black-box"));
}

}  // namespace

BlackBoxDialog::BlackBoxDialog(Workspace& workspace, QWidget* parent) : QDialog(parent), workspace_(workspace) {
  setObjectName(QStringLiteral("blackBoxDialog"));
  setWindowTitle(tr("Black Box of Frames"));
  setMinimumWidth(520);
  build();
  const auto wish = workspace_.runs().blackBox();
  on_->setChecked(wish.on);
  folder_->setText(QDir::toNativeSeparators(wish.folder.isEmpty() ? usualFolder() : wish.folder));
  mib_->setValue(wish.mib);
  connect(on_, &QCheckBox::toggled, this, &BlackBoxDialog::refresh);
  connect(folder_, &QLineEdit::textChanged, this, &BlackBoxDialog::refresh);
  connect(mib_, &QSpinBox::valueChanged, this, &BlackBoxDialog::refresh);
  connect(browse_, &QPushButton::clicked, this, &BlackBoxDialog::browse);
  connect(&workspace_.runs(), &NetworkRuns::diskChanged, this, &BlackBoxDialog::showState);
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &BlackBoxDialog::showState);
  timer->start(kStateInterval);
  refresh();
  showState();
}

void BlackBoxDialog::build() {
  auto* layout = new QVBoxLayout(this);
  auto* words = new QLabel(
      tr("Keeps the last frames of every run on disk, sent and received, in files that Wireshark reads. They "
         "are whole also after a crash or a power cut; the oldest are replaced."));
  words->setWordWrap(true);
  layout->addWidget(words);
  on_ = named(new QCheckBox(tr("&Keep the last frames of every run")), "blackBoxOn", tr("Keep the last frames"));
  layout->addWidget(on_);
  auto* form = new QFormLayout;
  auto* place = new QHBoxLayout;
  folder_ = named(new QLineEdit, "blackBoxFolder", tr("Folder of the files"));
  browse_ = named(new QPushButton(tr("&Browse…")), "blackBoxBrowse", tr("Choose the folder"));
  browse_->setAutoDefault(false);
  place->addWidget(folder_, 1);
  place->addWidget(browse_);
  auto* folder = new QLabel(tr("&Folder"));  // the form makes no buddy of a row that is a layout
  folder->setBuddy(folder_);
  form->addRow(folder, place);
  mib_ = named(new QSpinBox, "blackBoxMib", tr("Size of the files of a network together"));
  mib_->setRange(1, BlackBoxWish::kMostMib);
  mib_->setSuffix(QStringLiteral(" MiB"));
  form->addRow(tr("&Size"), mib_);
  layout->addLayout(form);
  reach_ = named(new QLabel, "blackBoxReach", tr("How much time it holds"));
  state_ = named(new QLabel, "blackBoxState", tr("What it holds now"));
  for (auto* label : {reach_, state_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(label);
  }
  layout->addStretch();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  ok_ = named(buttons->button(QDialogButtonBox::Ok), "blackBoxAccept", tr("OK"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

BlackBoxWish BlackBoxDialog::wish() const {
  return {on_->isChecked(), QDir::fromNativeSeparators(folder_->text().trimmed()), mib_->value()};
}

void BlackBoxDialog::browse() {
  const auto folder = QFileDialog::getExistingDirectory(this, tr("Folder of the Black Box"), folder_->text());
  if (!folder.isEmpty()) folder_->setText(QDir::toNativeSeparators(folder));
}

void BlackBoxDialog::refresh() {
  for (QWidget* field : {static_cast<QWidget*>(folder_), static_cast<QWidget*>(browse_), static_cast<QWidget*>(mib_)})
    field->setEnabled(on_->isChecked());
  ok_->setEnabled(!on_->isChecked() || !wish().folder.isEmpty());
  const auto* config = workspace_.configuration().config();
  const auto reach = config == nullptr ? 0 : black_box_reach(*config, static_cast<std::uint64_t>(mib_->value()) << 20U);
  reach_->setText(reach == 0 ? tr("How much time that holds follows from the frames of a cycle: there are none yet.")
                             : tr("Holds about the last %1 of this network's cycles.").arg(spanText(reach)));
}

void BlackBoxDialog::showState() {
  const auto& frames = workspace_.runs().current().frames;
  const auto report = frames.report();
  state_->setVisible(frames.isKeeping() || report.error || report.frames > 0);
  state_->setText(blackBoxText(report));
}

void BlackBoxDialog::accept() {
  workspace_.setBlackBox(wish());
  QDialog::accept();
}

}  // namespace syncline::ui
