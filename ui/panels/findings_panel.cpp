// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/findings_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/finding_model.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

theme::Tone toneOf(Severity level) {
  if (level == Severity::kError) return theme::Tone::kBad;
  return level == Severity::kWarning ? theme::Tone::kWarning : theme::Tone::kNeutral;
}

/// Colours the severity; the word stands in the cell, colour only helps.
class LevelDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const auto level = static_cast<Severity>(index.data(FindingModel::kLevelRole).toInt());
    option->palette.setColor(QPalette::Text, theme::toneColor(option->palette, toneOf(level)));
  }
};

}  // namespace

FindingsPanel::FindingsPanel(FindingModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  table_ = named(new QTableView, "findingsTable", tr("Findings about the project and the running bus"));
  setUpTable(*table_);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setModel(&model);
  table_->setItemDelegateForColumn(FindingModel::kSeverity, new LevelDelegate(table_));
  table_->setWordWrap(true);
  table_->setTextElideMode(Qt::ElideRight);
  table_->setColumnWidth(FindingModel::kSeverity, 92);
  table_->setColumnWidth(FindingModel::kWhere, 92);
  table_->horizontalHeader()->setSectionResizeMode(FindingModel::kFinding, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(FindingModel::kAdvice, QHeaderView::Stretch);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    if (const auto from = index.data(FindingModel::kFromRole).toLongLong(); from != 0) Q_EMIT momentActivated(from);
    const auto finding = model_.finding(index.row());  // a copy: the rows may be others by then
    Q_EMIT findingActivated(finding);
  });
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_, &QWidget::customContextMenuRequested, this, &FindingsPanel::openMenu);
  nothing_ = new QLabel;
  nothing_->setObjectName(QStringLiteral("noFindings"));
  nothing_->setAlignment(Qt::AlignCenter);
  nothing_->setWordWrap(true);
  nothing_->setEnabled(false);
  setUntold(false);
  layout->addWidget(table_, 1);
  layout->addWidget(nothing_, 1);
  connect(&model_, &QAbstractItemModel::rowsInserted, this, &FindingsPanel::showState);
  connect(&model_, &QAbstractItemModel::rowsRemoved, this, &FindingsPanel::showState);
  showState();
}

void FindingsPanel::openMenu(const QPoint& at) {
  const auto index = table_->indexAt(at);
  if (!index.isValid()) return;
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("findingMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  Q_EMIT menuOpens(*menu, model_.finding(index.row()));
  menu->popup(table_->viewport()->mapToGlobal(at));
}

void FindingsPanel::setUntold(bool untold) {
  nothing_->setText(untold
                        ? tr("A moment of a recording is shown. Findings are of the whole run: they stand at its end.")
                        : tr("Nothing found. What is wrong with the project, and what the running bus shows to be "
                             "wrong, stands here with its cause and what to do."));
}

void FindingsPanel::selectMoment(qint64 moment) {
  for (int row = 0; row < model_.rowCount(); ++row) {
    const auto index = model_.index(row, 0);
    const auto from = index.data(FindingModel::kFromRole).toLongLong();
    if (from == 0 || moment < from || moment > std::max(from, index.data(FindingModel::kToRole).toLongLong())) continue;
    return table_->selectRow(row);
  }
  table_->clearSelection();
}

void FindingsPanel::showState() {
  const bool any = model_.rowCount() > 0;
  table_->setVisible(any);
  nothing_->setVisible(!any);
}

}  // namespace syncline::ui
