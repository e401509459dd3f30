// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/sync_window_fields.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>

#include "config/project.h"
#include "protocol/system_time_difference.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/number_edit.h"
#include "ui/editors/page.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {

SyncWindowFields::SyncWindowFields(Page& page, Card& card) {
  auto& fields = page.fields();
  monitoring_ = fields.toggle(card, "syncWindow", "master.dc.sync_window");
  exponent_ = fields.numberField("syncWindowExponent", "master.dc.sync_window_exponent");
  auto* field = new QWidget;
  auto* layout = new QHBoxLayout(field);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(exponent_);
  field->setFocusProxy(exponent_);
  limit_ = named(new QLabel, "syncWindowLimit", QCoreApplication::translate("SyncWindowFields", "Limit"));
  layout->addWidget(limit_, 1);
  card.addRow(exponent_->accessibleName(), field, exponent_->toolTip());
  settle_ = fields.number(card, "syncWindowSettle", "master.dc.sync_window_settle_ms");
}

void SyncWindowFields::show(const DcMasterSettings& dc) {
  limit_->setText(QStringLiteral("= ") + timeText(sync_window_limit_ns(dc.sync_window.exponent)));
  monitoring_->setEnabled(dc.enabled);
  exponent_->setEnabled(dc.enabled && dc.sync_window.enabled);
  settle_->setEnabled(dc.enabled && dc.sync_window.enabled);
}

}  // namespace syncline::ui
