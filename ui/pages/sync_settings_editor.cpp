// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/sync_settings_editor.h"

#include <QLabel>
#include <algorithm>

#include "families/device_family.h"
#include "families/families.h"
#include "protocol/sync_error_counter.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/page.h"
#include "ui/text/joined_text.h"
#include "ui/text/setting_text.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kMostMisses = 10, kWeight = kMissWeight;
constexpr const char* kErrorLimit = "slave.N.sync.error_limit";

/// Shows `value`, also one that the list does not offer.
void choose(QComboBox& box, const QVariant& value) {
  auto row = box.findData(value);
  if (row < 0) {
    box.addItem(value.toString(), value);
    row = box.count() - 1;
  }
  box.setCurrentIndex(row);
}

QString stepText(const families::CycleLimits& limits) {
  QStringList parts;
  if (limits.step > 1) parts << SyncSettingsEditor::tr("multiples of %1").arg(cycleText(limits.full_step));
  if (limits.step <= 1 && limits.shortest > 0)
    parts << SyncSettingsEditor::tr("from %1").arg(cycleText(limits.shortest));
  if (limits.longest > 0) parts << SyncSettingsEditor::tr("to %1").arg(cycleText(limits.longest));
  return joinedParts(parts);
}

}  // namespace

SyncSettingsEditor::SyncSettingsEditor(Card& card, Page& page) : QObject(&page) {
  family_ = card.addValue("deviceFamily", tr("Device family"),
                          tr("Whose limits are known beyond the ESI (docs/device-families.md)"));
  cycles_ =
      card.addValue("familyCycles", tr("SYNC0 cycles"), tr("What the device takes; others are refused at SAFEOP"));
  limit_ = named(new ChoiceEdit, "syncErrorLimit", settingLabel(settings::row(kErrorLimit)));
  connect(limit_, &QComboBox::activated, this, [this, &page] {
    const auto limit = limit_->currentData();
    page.fields().set(kErrorLimit, limit.isValid() ? settings::Value{std::int64_t{limit.toInt()}} : settings::Value{});
  });
  limit_->setMinimumContentsLength(14);
  page.fields().bind(*limit_, kErrorLimit);
  card.addRow(limit_->accessibleName(), limit_, limit_->toolTip());
  type_ = page.fields().choice(card, "syncType", "slave.N.sync.type");
  type_->setMinimumContentsLength(14);
  page.fields().keys(card, {"slave.N.sync.input_shift_us"},
                     [](const SlaveSettings& slave) { return slave.device.mailbox && slave.device.mailbox->coe; });
}

void SyncSettingsEditor::showSlave(const SlaveSettings& slave) {
  const auto* family = families::find(slave.device);
  const auto name = [](std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
  };
  family_->setText(family != nullptr ? name(family->name) : noText());
  const auto cycles = family != nullptr && family->cycle ? stepText(*family->cycle) : QString();
  cycles_->setText(cycles.isEmpty() ? noText() : cycles);
  showLimit(slave);
  type_->setEnabled(slave.device.mailbox && slave.device.mailbox->coe);
}

void SyncSettingsEditor::showLimit(const SlaveSettings& slave) {
  const auto* family = families::find(slave.device);
  const auto* known = family != nullptr && family->error_limit ? &*family->error_limit : nullptr;
  limit_->clear();
  limit_->addItem(known != nullptr ? tr("As device (%1)").arg(known->usual) : tr("As device"), QVariant());
  limit_->addItem(tr("0 (never gives up)"), 0);
  const int most = known != nullptr ? std::min(known->largest / kWeight, kMostMisses) : kMostMisses;
  for (int misses = 1; misses <= most; ++misses) {
    limit_->addItem(tr("%1 (%n miss(es) in a row)", "", misses).arg(misses * kWeight), misses * kWeight);
  }
  choose(*limit_, slave.sync.error_limit ? QVariant(*slave.sync.error_limit) : QVariant());
  limit_->setEnabled(slave.device.mailbox && slave.device.mailbox->coe);
}

}  // namespace syncline::ui
