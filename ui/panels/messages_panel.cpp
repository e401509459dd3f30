// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/messages_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/models/message_model.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

theme::Tone messageTone(Severity severity) {
  if (severity == Severity::kError) return theme::Tone::kBad;
  return severity == Severity::kWarning ? theme::Tone::kWarning : theme::Tone::kNeutral;
}

QString iconOf(Severity severity) {
  if (severity == Severity::kError) return QStringLiteral("error");
  return severity == Severity::kWarning ? QStringLiteral("warning") : QStringLiteral("info");
}

/// Colours the severity column; the word stands in the cell, colour only helps.
class SeverityDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const auto severity = static_cast<Severity>(index.data(MessageModel::kSeverityRole).toInt());
    const auto color = theme::toneColor(option->palette, messageTone(severity));
    option->palette.setColor(QPalette::Text, color);
  }
};

}  // namespace

MessagesPanel::MessagesPanel(MessageModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(8, 3, 8, 3);
  bar->setSpacing(4);
  filter_ = new MessageFilter(this);
  filter_->setSourceModel(&model);
  bar->addWidget(addSwitch(Severity::kError, "showErrors"));
  bar->addWidget(addSwitch(Severity::kWarning, "showWarnings"));
  bar->addWidget(addSwitch(Severity::kNote, "showInformation"));
  text_ = named(new QLineEdit, "messageFilter", tr("Filter messages"));
  text_->setPlaceholderText(tr("Filter"));
  text_->setClearButtonEnabled(true);
  text_->setMaximumWidth(280);
  connect(text_, &QLineEdit::textChanged, filter_, &MessageFilter::setText);
  bar->addStretch(1);
  bar->addWidget(text_, 1);
  clear_ = named(new QToolButton, "clearMessages", tr("Clear the log"));
  clear_->setToolTip(tr("Clear the log; findings about the project stay"));
  clear_->setAutoRaise(true);
  connect(clear_, &QToolButton::clicked, &model_, &MessageModel::clearLog);
  bar->addWidget(clear_);
  layout->addLayout(bar);

  table_ = named(new QTableView, "messageTable", tr("Messages"));
  setUpTable(*table_);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setModel(filter_);
  table_->setItemDelegateForColumn(MessageModel::kSeverity, new SeverityDelegate(table_));
  table_->setColumnWidth(MessageModel::kTime, 96);
  table_->setColumnWidth(MessageModel::kRunTime, 86);
  table_->setColumnWidth(MessageModel::kSeverity, 92);
  table_->setColumnWidth(MessageModel::kSource, 150);
  stretchColumn(*table_, MessageModel::kText);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    // A copy: another network may come in work, and then the rows are others.
    const auto message = model_.message(filter_->mapToSource(index).row());
    Q_EMIT activated(message);
  });
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_, &QWidget::customContextMenuRequested, this, &MessagesPanel::openMenu);
  layout->addWidget(table_, 1);
  connect(&model_, &QAbstractItemModel::rowsInserted, this, &MessagesPanel::updateCounts);
  connect(&model_, &QAbstractItemModel::rowsRemoved, this, &MessagesPanel::updateCounts);
  drawIcons();
  updateCounts();
}

void MessagesPanel::openMenu(const QPoint& at) {
  const auto index = filter_->mapToSource(table_->indexAt(at));
  if (!index.isValid()) return;
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("messageMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  Q_EMIT menuOpens(*menu, model_.message(index.row()));
  menu->popup(table_->viewport()->mapToGlobal(at));
}

void MessagesPanel::selectMoment(qint64 moment) {
  for (int row = 0; row < filter_->rowCount(); ++row) {
    const auto index = filter_->index(row, 0);
    if (moment == 0 || index.data(MessageModel::kMomentRole).toLongLong() != moment) continue;
    table_->selectRow(row);
    return table_->scrollTo(index, QAbstractItemView::PositionAtCenter);
  }
  table_->clearSelection();
}

QToolButton* MessagesPanel::addSwitch(Severity severity, const char* object_name) {
  const QString names[] = {tr("Show information"), tr("Show warnings"), tr("Show errors")};
  auto* button = named(new QToolButton, object_name, names[static_cast<int>(severity)]);
  button->setToolTip(names[static_cast<int>(severity)]);
  button->setCheckable(true);
  button->setChecked(true);
  button->setAutoRaise(true);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(button, &QToolButton::toggled, this, [this, severity](bool on) { filter_->setShown(severity, on); });
  switches_[static_cast<int>(severity)] = button;
  return button;
}

void MessagesPanel::updateCounts() {
  for (const auto severity : {Severity::kNote, Severity::kWarning, Severity::kError}) {
    switches_[static_cast<int>(severity)]->setText(QString::number(model_.count(severity)));
  }
}

void MessagesPanel::drawIcons() {
  for (const auto severity : {Severity::kNote, Severity::kWarning, Severity::kError}) {
    switches_[static_cast<int>(severity)]->setIcon(
        theme::icon(iconOf(severity), palette(), theme::toneColor(palette(), messageTone(severity))));
  }
  clear_->setIcon(theme::icon(QStringLiteral("clear"), palette()));
}

void MessagesPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && clear_ != nullptr) drawIcons();
}

}  // namespace syncline::ui
