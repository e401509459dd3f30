// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/limit_fields.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include "config/monitor_view.h"
#include "ui/text/typed_value.h"

namespace syncline::ui {

LimitFields::LimitFields(const QString& name, const QString& spoken, QWidget* parent)
    : QWidget(parent), fixed_(new QCheckBox(tr("fixed"))), low_(new QLineEdit), high_(new QLineEdit) {
  setObjectName(name);
  setAccessibleName(spoken);
  fixed_->setObjectName(name + QStringLiteral("Fixed"));
  fixed_->setAccessibleName(tr("%1: fixed limits").arg(spoken));
  low_->setObjectName(name + QStringLiteral("Low"));
  low_->setAccessibleName(tr("%1: from").arg(spoken));
  high_->setObjectName(name + QStringLiteral("High"));
  high_->setAccessibleName(tr("%1: to").arg(spoken));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(fixed_);
  layout->addWidget(low_, 1);
  layout->addWidget(new QLabel(QStringLiteral("\u2026")));
  layout->addWidget(high_, 1);
  for (auto* field : {low_, high_}) {
    field->setMinimumWidth(80);
    connect(field, &QLineEdit::textEdited, this, &LimitFields::changed);
  }
  connect(fixed_, &QCheckBox::toggled, this, [this] {
    showState();
    Q_EMIT changed();
  });
  showState();
}

void LimitFields::showState() {
  for (auto* field : {low_, high_}) field->setEnabled(fixed_->isChecked());
}

void LimitFields::setTimes(bool times, const QString& unit) {
  times_ = times;
  const auto tip = times            ? tr("In ns, or with its unit: ns, \u00B5s, ms, s")
                   : unit.isEmpty() ? tr("A number")
                                    : tr("A number, in %1").arg(unit);
  for (auto* field : {low_, high_}) field->setToolTip(tip);
}

void LimitFields::setLimits(const std::optional<AxisLimits>& limits, const AxisLimits& shown) {
  const QSignalBlocker quiet(this);
  const auto& there = limits ? *limits : shown;
  low_->setText(valueToType(there.low));
  high_->setText(valueToType(there.high));
  fixed_->setChecked(limits.has_value());
  showState();
}

std::optional<AxisLimits> LimitFields::limits() const {
  if (!fixed_->isChecked()) return std::nullopt;
  const auto low = typedValue(low_->text(), times_);
  const auto high = typedValue(high_->text(), times_);
  if (!low || !high || !(*low < *high)) return std::nullopt;
  return AxisLimits{*low, *high};
}

bool LimitFields::isValid() const { return !fixed_->isChecked() || limits().has_value(); }

}  // namespace syncline::ui
