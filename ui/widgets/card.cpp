// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/card.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/theme/theme.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {

namespace {

constexpr int kCardMargin = 12, kSpacing = 10;
constexpr int kWidest = 640;  // of a card: a field wider than that says nothing more

}  // namespace

Card::Card(const QString& title, QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 8, 14, 10);
  layout->setSpacing(6);
  heading_ = new QLabel(title, this);
  auto font = heading_->font();
  font.setWeight(QFont::DemiBold);
  heading_->setFont(font);
  layout->addWidget(heading_);
  form_ = new QFormLayout;
  form_->setHorizontalSpacing(14);
  form_->setVerticalSpacing(5);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form_->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  layout->addLayout(form_);
}

void Card::addRow(const QString& label, QWidget* field, const QString& tool_tip) {
  auto* caption = new QLabel(label, this);
  caption->setBuddy(field);
  caption->setToolTip(tool_tip);
  if (field->toolTip().isEmpty()) field->setToolTip(tool_tip);
  form_->addRow(caption, field);
}

void Card::addWide(QWidget* field, const QString& tool_tip) {
  if (!tool_tip.isEmpty()) field->setToolTip(tool_tip);
  form_->addRow(field);
}

QLabel* Card::addValue(const char* object_name, const QString& label, const QString& tool_tip) {
  auto* value = new ValueLabel(QStringLiteral("\u2013"), this);
  value->setObjectName(QLatin1String(object_name));
  value->setAccessibleName(label);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setMinimumHeight(fontMetrics().height() + 2);
  addRow(label, value, tool_tip);
  return value;
}

void Card::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme::outline(palette()));
  painter.setBrush(palette().base());
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
}

void alignLabels(const QList<Card*>& cards) {
  QList<QWidget*> labels;
  int width = 0;
  for (auto* card : cards) {
    auto* form = card->form();
    for (int row = 0; row < form->rowCount(); ++row) {
      auto* item = form->itemAt(row, QFormLayout::LabelRole);
      if (item == nullptr || item->widget() == nullptr) continue;
      labels << item->widget();
      if (form->isRowVisible(row)) width = std::max(width, item->widget()->sizeHint().width());
    }
  }
  for (auto* label : labels) label->setMinimumWidth(width);
}

CardColumns::CardColumns(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kCardMargin, 10, kCardMargin, 10);
  layout->setSpacing(kSpacing);
  layout->addStretch();  // what is left where all cards are as wide as they may be
}

Card* CardColumns::add(int column, const QString& title) {
  while (columns_.size() <= column) columns_.append(QList<Card*>());
  auto* card = new Card(title, this);
  columns_[column].append(card);
  return card;
}

/// 0: none of its cards is shown.
int CardColumns::widthOf(qsizetype column) const {
  int width = 0;
  for (const auto* card : columns_[column]) {
    if (!card->isHidden()) width = std::max(width, card->minimumSizeHint().width());
  }
  return width;
}

/// How many stacks of columns that show something fit beside each other in this width; at least one.
int CardColumns::fitting(int width) const {
  QList<int> widths;
  for (qsizetype i = 0; i < columns_.size(); ++i) {
    if (const int needed = widthOf(i); needed > 0) widths.append(needed);
  }
  for (auto stacks = widths.size(); stacks > 1; --stacks) {
    int needed = 2 * kCardMargin - kSpacing;
    for (qsizetype stack = 0; stack < stacks; ++stack) {
      int widest = 0;
      for (auto i = stack; i < widths.size(); i += stacks) widest = std::max(widest, widths[i]);
      needed += widest + kSpacing;
    }
    if (needed <= width) return static_cast<int>(stacks);
  }
  return 1;
}

void CardColumns::arrange() {
  const int wanted = fitting(width());
  QList<Card*> order;
  QList<int> stack_of;
  int used = 0;
  for (qsizetype i = 0; i < columns_.size(); ++i) {
    for (auto* card : columns_[i]) {
      card->setMaximumWidth(std::max(kWidest, card->minimumSizeHint().width()));
      order.append(card);
      stack_of.append(used % wanted);
    }
    if (widthOf(i) > 0) ++used;
  }
  if (stack_of == placed_ && shown_ == wanted) return;
  shown_ = wanted;
  placed_ = stack_of;
  auto* row = static_cast<QHBoxLayout*>(layout());
  for (auto* stack : stacks_) {
    while (auto* item = stack->takeAt(0)) delete item;
    row->removeItem(stack);
    delete stack;
  }
  stacks_.clear();
  for (int i = 0; i < wanted; ++i) {
    stacks_.append(new QVBoxLayout);
    stacks_.last()->setSpacing(kSpacing);
    row->insertLayout(i, stacks_.last(), 1);
  }
  for (qsizetype i = 0; i < order.size(); ++i) stacks_[stack_of[i]]->addWidget(order[i]);
  for (auto* stack : stacks_) stack->addStretch(1);
  orderTabs();
  updateGeometry();
}

/// Down one column, then down the next, whatever was made first.
void CardColumns::orderTabs() {
  QWidget* last = nullptr;
  for (const auto* stack : stacks_) {
    for (int i = 0; i < stack->count(); ++i) {
      auto* card = stack->itemAt(i)->widget();
      if (card == nullptr) continue;
      for (auto* field : card->findChildren<QWidget*>()) {
        if (field->window() != window()) continue;  // the list that a choice opens
        // The line edit of a spin box goes with it.
        const bool inner = qobject_cast<QAbstractSpinBox*>(field->parentWidget()) != nullptr ||
                           qobject_cast<QComboBox*>(field->parentWidget()) != nullptr;
        if (inner || (field->focusPolicy() & Qt::TabFocus) == 0 || field->focusProxy() != nullptr) continue;
        if (last != nullptr) setTabOrder(last, field);
        last = field;
      }
    }
  }
}

int CardColumns::rows() const {
  int rows = 0;
  for (const auto& column : columns_) {
    for (auto* card : column) rows += card->form()->rowCount();
  }
  return rows;
}

QSize CardColumns::minimumSizeHint() const {
  int widest = 0;
  for (qsizetype i = 0; i < columns_.size(); ++i) widest = std::max(widest, widthOf(i));
  return {widest + 2 * kCardMargin, layout()->minimumSize().height()};
}

bool CardColumns::event(QEvent* event) {
  // Cards came, went or grew.
  if (event->type() == QEvent::LayoutRequest) {
    arrange();
    const int before = std::exchange(rows_, rows());
    if (before != rows_) orderTabs();
  }
  return QWidget::event(event);
}

void CardColumns::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

}  // namespace syncline::ui
