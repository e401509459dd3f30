// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/limits_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include "ui/widgets/limit_fields.h"

namespace syncline::ui {

LimitsDialog::LimitsDialog(TracePanel& panel, QWidget* parent) : QDialog(parent), panel_(&panel) {
  setObjectName(QStringLiteral("limitsDialog"));
  setWindowTitle(tr("Value Limits: %1").arg(panel.title()));
  auto* form = new QFormLayout(this);
  left_ = addAxis(panel, TracePlot::kLeft, QStringLiteral("limitsLeft"), tr("Left axis"));
  form->addRow(tr("Left axis"), left_);
  if (panel.plot()->isAxisVisible(panel.plot()->axis(TracePlot::kRight).id())) {
    right_ = addAxis(panel, TracePlot::kRight, QStringLiteral("limitsRight"), tr("Right axis"));
    form->addRow(tr("Right axis"), right_);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &LimitsDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  const auto look = [this, buttons] {
    const bool valid = left_->isValid() && (right_ == nullptr || right_->isValid());
    buttons->button(QDialogButtonBox::Ok)->setEnabled(valid);
  };
  for (auto* fields : {left_, right_}) {
    if (fields != nullptr) connect(fields, &LimitFields::changed, this, look);
  }
}

LimitFields* LimitsDialog::addAxis(const TracePanel& panel, TracePlot::Side side, const QString& name,
                                   const QString& spoken) {
  const auto& axis = panel.plot()->axis(side);
  auto* fields = new LimitFields(name, spoken);
  fields->setTimes(axis.options().kind == ValueAxis::Quantity::kTime, axis.options().unit);
  const AxisLimits shown{axis.low(), axis.high()};
  fields->setLimits(axis.isFixed() ? std::optional(shown) : std::nullopt, shown);
  return fields;
}

void LimitsDialog::accept() {
  const auto left = left_->limits();
  const auto right = right_ == nullptr ? std::nullopt : right_->limits();
  if (auto* panel = panel_.data()) {
    panel->setLimits(TracePlot::kLeft, left);
    if (right_ != nullptr) panel->setLimits(TracePlot::kRight, right);
  }
  QDialog::accept();
}

}  // namespace syncline::ui
