// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/card.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/theme/theme.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {

Card::Card(const QString& title, QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 8, 14, 10);
  layout->setSpacing(6);
  auto* heading = new QLabel(title, this);
  auto font = heading->font();
  font.setWeight(QFont::DemiBold);
  heading->setFont(font);
  layout->addWidget(heading);
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

CardColumns::CardColumns(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 10, 12, 10);
  layout->setSpacing(10);
}

Card* CardColumns::add(int column, const QString& title) {
  auto* row = static_cast<QHBoxLayout*>(layout());
  while (columns_.size() <= column) {
    auto* stack = new QVBoxLayout;
    stack->setSpacing(10);
    row->addLayout(stack, 1);
    columns_.append(stack);
  }
  auto* card = new Card(title, this);
  columns_[column]->addWidget(card);
  return card;
}

void CardColumns::addStretch() {
  for (auto* column : columns_) column->addStretch(1);
}

}  // namespace syncline::ui
