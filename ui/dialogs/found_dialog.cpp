// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/found_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/dialogs/questions.h"
#include "ui/models/found_model.h"
#include "ui/text/joined_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

theme::Tone toneOf(FoundKind kind) {
  if (kind == FoundKind::kMatched) return theme::Tone::kGood;
  return kind == FoundKind::kMissing || kind == FoundKind::kOtherDevice ? theme::Tone::kBad : theme::Tone::kWarning;
}

/// Colours the status; the word stands in the cell.
class KindDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const auto kind = static_cast<FoundKind>(index.data(FoundModel::kKindRole).toInt());
    option->palette.setColor(QPalette::Text, theme::toneColor(option->palette, toneOf(kind)));
  }
};

QString summary(const FoundModel& model, const QString& bus) {
  QStringList parts{FoundDialog::tr("%n match(es)", nullptr, model.count(FoundKind::kMatched))};
  const auto add = [&](FoundKind kind, const QString& text) {
    if (model.count(kind) > 0) parts << text;
  };
  add(FoundKind::kExtra, FoundDialog::tr("%n additional", nullptr, model.count(FoundKind::kExtra)));
  add(FoundKind::kMissing, FoundDialog::tr("%n missing", nullptr, model.count(FoundKind::kMissing)));
  add(FoundKind::kMoved, FoundDialog::tr("%n moved", nullptr, model.count(FoundKind::kMoved)));
  add(FoundKind::kRewired, FoundDialog::tr("%n wired otherwise", nullptr, model.count(FoundKind::kRewired)));
  add(FoundKind::kRevision, FoundDialog::tr("%n in another revision", nullptr, model.count(FoundKind::kRevision)));
  add(FoundKind::kOtherDevice, FoundDialog::tr("%n other device(s)", nullptr, model.count(FoundKind::kOtherDevice)));
  return FoundDialog::tr("Bus: %1. Beside the project: %2.").arg(bus, joinedParts(parts));
}

QLabel* paragraph(const char* object_name, const QString& text) {
  auto* label = new QLabel(text);
  label->setObjectName(QLatin1String(object_name));
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setWordWrap(true);
  return label;
}

}  // namespace

FoundDialog::FoundDialog(const Project& ours, ScanOutcome outcome, const QString& bus, QWidget* parent)
    : QDialog(parent), ours_(ours), outcome_(std::move(outcome)) {
  setObjectName(QStringLiteral("foundDialog"));
  setWindowTitle(tr("Scan Result"));
  resize(980, 460);
  model_ = new FoundModel(ours_, outcome_.built.project, this);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(10);
  layout->addWidget(paragraph("foundSummary", summary(*model_, bus)));
  auto* buttons = new QDialogButtonBox;
  if (outcome_.looked_only) {
    layout->addWidget(paragraph(
        "foundLooked", tr("%n slave(s) of this bus are running. They were only looked at and nothing was written, so "
                          "some of what they are may not be known.",
                          nullptr, static_cast<int>(outcome_.running))));
    auto* touch = named(new QPushButton(tr("Scan &Fully…")), "foundTouch", tr("Scan fully"));
    buttons->addButton(touch, QDialogButtonBox::ActionRole);
    connect(touch, &QPushButton::clicked, this, [this] {
      if (!ask(*this, "touchQuestion", tr("Touch the running machine?"),
               tr("States stay as they are. EEPROMs are taken from their devices while they are read, the receive "
                  "times of all slaves are latched, and slaves without a description are asked in PREOP."),
               tr("Scan Fully"))) {
        return;
      }
      reject();
      Q_EMIT touchWanted();
    });
  }
  auto* table = named(new QTableView, "foundTable", tr("Slaves in the project and on the bus"));
  setUpTable(*table);
  table->setModel(model_);
  table->setItemDelegateForColumn(FoundModel::kStatus, new KindDelegate(table));
  table->setColumnWidth(FoundModel::kStatus, 150);
  table->setColumnWidth(FoundModel::kOurs, 210);
  table->setColumnWidth(FoundModel::kFound, 150);
  stretchColumn(*table, FoundModel::kDifference);
  table->setCurrentIndex(model_->index(0, 0));
  layout->addWidget(table, 1);
  lost_ = paragraph("foundLost", {});
  layout->addWidget(lost_);
  take_ = named(new QPushButton(tr("&Take Over Ticked")), "foundTake", tr("Take over what is ticked"));
  auto* replace_all = named(new QPushButton(tr("&Replace Project…")), "foundReplace", tr("Replace the project"));
  replace_all->setToolTip(tr("A new project of the bus with the defaults of its devices; all settings go"));
  auto* keep = named(new QPushButton(tr("&Keep Project")), "foundKeep", tr("Keep the project"));
  buttons->addButton(take_, QDialogButtonBox::AcceptRole);
  buttons->addButton(replace_all, QDialogButtonBox::ActionRole);
  buttons->addButton(keep, QDialogButtonBox::RejectRole);
  take_->setDefault(true);
  layout->addWidget(buttons);
  connect(take_, &QPushButton::clicked, this, &FoundDialog::takeTicked);
  connect(replace_all, &QPushButton::clicked, this, &FoundDialog::replace);
  connect(keep, &QPushButton::clicked, this, &QDialog::reject);
  connect(model_, &QAbstractItemModel::dataChanged, this, &FoundDialog::showChoice);
  showChoice();
}

void FoundDialog::showChoice() {
  const int ticked = model_->tickedCount();
  take_->setEnabled(ticked > 0);
  const auto lost = take_over(ours_, outcome_.built.project, model_->lines(), model_->ticked()).lost;
  QStringList keys;
  for (const auto& key : lost) keys << QString::fromStdString(key);
  lost_->setText(tr("The other revision does not take these settings: %1").arg(joinedParts(keys)));
  lost_->setVisible(!keys.isEmpty());
}

void FoundDialog::takeTicked() {
  auto taken = take_over(ours_, outcome_.built.project, model_->lines(), model_->ticked());
  QStringList keys;
  for (const auto& key : taken.lost) keys << QString::fromStdString(key);
  accept();
  Q_EMIT wanted(taken.project, keys);
}

void FoundDialog::replace() {
  if (!ask(*this, "replaceQuestion", tr("Replace the whole project?"), tr("Its settings go; Undo brings them back."),
           tr("Replace"))) {
    return;
  }
  accept();
  Q_EMIT wanted(outcome_.built.project, {});
}

}  // namespace syncline::ui
