// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/replace_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "compare/replaced_slave.h"
#include "settings/settings_table.h"
#include "ui/dialogs/slave_commands.h"
#include "ui/session/device_catalogue.h"
#include "ui/text/error_text.h"
#include "ui/text/joined_text.h"
#include "ui/text/setting_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kMostNamed = 6;

QString typeOf(const DeviceDescription& device) {
  return QString::fromStdString(device.type.empty() ? device.name : device.type).trimmed();
}

/// "Alias, Revision rule and 3 more".
QString labelsOf(const Project& project, const std::vector<std::string>& keys) {
  QStringList labels;
  for (const auto& key : keys) {
    const auto ref = settings::find(project, key, false);
    const auto label = ref ? settingLabel(*ref->setting) : QString::fromStdString(key);
    if (!labels.contains(label)) labels << label;
  }
  if (labels.size() <= kMostNamed) return joinedParts(labels);
  const auto more = static_cast<int>(labels.size()) - kMostNamed;
  return ReplaceDialog::tr("%1 and %n more", nullptr, more).arg(joinedParts(labels.mid(0, kMostNamed)));
}

}  // namespace

ReplaceDialog::ReplaceDialog(const Project& project, int slave, DeviceCatalogue& catalogue, QWidget* parent)
    : QDialog(parent), project_(project), slave_(slave), catalogue_(catalogue) {
  setObjectName(QStringLiteral("replaceDialog"));
  const auto& old = project_.slaves[static_cast<std::size_t>(slave)];
  setWindowTitle(tr("Replace %1").arg(QString::fromStdString(old.name)));
  setMinimumSize(520, 380);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      new QLabel(tr("Now: %1, revision %2").arg(typeOf(old.device), hexText(old.device.identity.revision_no, 8))));
  words_ = named(new QLineEdit, "replaceSearch", tr("Search for another device"));
  words_->setPlaceholderText(tr("Its revisions are listed; type to search for another device"));
  words_->setClearButtonEnabled(true);
  list_ = named(new QListWidget, "replaceList", tr("What it can be replaced by"));
  effect_ = named(new QLabel, "replaceEffect", tr("What changes"));
  effect_->setWordWrap(true);
  effect_->setMinimumHeight(3 * fontMetrics().lineSpacing());
  effect_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  layout->addWidget(words_);
  layout->addWidget(list_, 1);
  layout->addWidget(effect_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  replace_ = buttons->addButton(tr("Replace"), QDialogButtonBox::AcceptRole);
  replace_->setObjectName(QStringLiteral("replaceGo"));
  replace_->setEnabled(false);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  typing_.setSingleShot(true);
  typing_.setInterval(80);
  connect(words_, &QLineEdit::textChanged, &typing_, qOverload<>(&QTimer::start));
  connect(&typing_, &QTimer::timeout, this, &ReplaceDialog::search);
  connect(list_, &QListWidget::currentRowChanged, this, &ReplaceDialog::readChosen);
  search();
}

void ReplaceDialog::search() {
  if (words_->text().isEmpty()) {
    const auto& identity = project_.slaves[static_cast<std::size_t>(slave_)].device.identity;
    return catalogue_.revisions(identity, this, [this](const Result<std::vector<eni::CatalogueEntry>>& entries) {
      if (!entries) return effect_->setText(errorText(entries.error()));
      if (words_->text().isEmpty()) showEntries(*entries);
    });
  }
  eni::CatalogueSearch wanted;
  wanted.words = words_->text().toStdString();
  wanted.limit = 200;
  catalogue_.search(wanted, this, [this](const Result<CatalogueAnswer>& answer) {
    if (!answer) return effect_->setText(errorText(answer.error()));
    if (answer->search.words == words_->text().toStdString()) showEntries(answer->entries);
  });
}

void ReplaceDialog::showEntries(const std::vector<eni::CatalogueEntry>& entries) {
  entries_ = entries;
  list_->clear();
  for (const auto& entry : entries_) {
    const auto name = QString::fromStdString(entry.name.empty() ? entry.type : entry.name).trimmed();
    list_->addItem(tr("%1, revision %2").arg(name, hexText(entry.identity.revision_no, 8)));
  }
  device_.reset();
  replace_->setEnabled(false);
  effect_->setText(entries_.empty() ? tr("The catalogue has no such device: read its ESI file, or type another name.")
                                    : tr("Choose one to see what changes."));
}

void ReplaceDialog::readChosen() {
  device_.reset();
  replace_->setEnabled(false);
  const auto row = list_->currentRow();
  if (row < 0) return;
  const auto wanted = entries_[static_cast<std::size_t>(row)];
  effect_->setText(tr("Reading…"));
  catalogue_.read(wanted, this, [this, row, id = wanted.id](const Result<DeviceDescription>& read) {
    const bool still = list_->currentRow() == row && row < static_cast<int>(entries_.size()) &&
                       entries_[static_cast<std::size_t>(row)].id == id;
    if (still) showEffect(read);
  });
}

void ReplaceDialog::showEffect(const Result<DeviceDescription>& read) {
  if (!read) return effect_->setText(errorText(read.error()));
  const auto replaced = replace_device(project_, static_cast<std::size_t>(slave_), *read);
  if (!replaced) return effect_->setText(obstacleText(replaced.error()));
  device_ = *read;
  replace_->setEnabled(true);
  replace_->setDefault(true);
  effect_->setText(replaced->lost.empty()
                       ? tr("All settings stay.")
                       : tr("It does not take: %1. Everything else stays.").arg(labelsOf(project_, replaced->lost)));
}

}  // namespace syncline::ui
