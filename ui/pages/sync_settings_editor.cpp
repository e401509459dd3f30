// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/sync_settings_editor.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>

#include "config/families/families.h"
#include "settings/sync_settings.h"
#include "ui/session/setting_keys.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr int kMissWeight = 3;  // of a missed event; a good one takes 1 away
constexpr int kMostMisses = 10;

QString none() { return QStringLiteral("\u2013"); }

QComboBox* choices(const char* name, const QString& accessible) {
  auto* box = named(new QComboBox, name, accessible);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(14);
  return box;
}

/// Shows `value`, also one that the list does not offer.
void choose(QComboBox& box, const QString& value) {
  auto row = box.findData(value);
  if (row < 0) {
    box.addItem(value, value);
    row = box.count() - 1;
  }
  box.setCurrentIndex(row);
}

QString stepText(const families::CycleLimits& limits) {
  QString text = limits.step > 1 ? SyncSettingsEditor::tr("multiples of %1").arg(cycleText(limits.full_step)) : QString();
  const auto add = [&](const QString& part) { text += text.isEmpty() ? part : QStringLiteral(", ") + part; };
  if (limits.step <= 1 && limits.shortest > 0) add(SyncSettingsEditor::tr("from %1").arg(cycleText(limits.shortest)));
  if (limits.longest > 0) add(SyncSettingsEditor::tr("to %1").arg(cycleText(limits.longest)));
  return text;
}

}  // namespace

SyncSettingsEditor::SyncSettingsEditor(Card& card, QObject* parent) : QObject(parent) {
  family_ = card.addValue("deviceFamily", tr("Device family"), tr("Whose limits are known beyond the ESI (docs/device-families.md)"));
  cycles_ = card.addValue("familyCycles", tr("SYNC0 cycles"), tr("What the device takes; others are refused at SAFEOP"));
  limit_ = choices("syncErrorLimit", tr("Error limit"));
  connect(limit_, &QComboBox::activated, this, [this] {
    Q_EMIT edited(tr("Change error limit"), QLatin1String(keys::kErrorLimit), limit_->currentData().toString());
  });
  card.addRow(tr("Error limit"), limit_,
              tr("Object 0x10F1:02: a missed SM event counts 3, a good one takes 1 away; the device gives up at the limit"));
  type_ = choices("syncType", tr("Synchronisation type"));
  connect(type_, &QComboBox::activated, this, [this] {
    Q_EMIT edited(tr("Change synchronisation type"), QLatin1String(keys::kSyncType), type_->currentData().toString());
  });
  card.addRow(tr("Type"), type_, tr("Objects 0x1C32:01 and 0x1C33:01: what starts the device's cycle"));
}

void SyncSettingsEditor::show(const SlaveSettings& slave) {
  const auto* family = families::find(slave.device);
  const auto name = [](std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); };
  family_->setText(family != nullptr ? name(family->name) : none());
  const auto cycles = family != nullptr && family->cycle ? stepText(*family->cycle) : QString();
  cycles_->setText(cycles.isEmpty() ? none() : cycles);
  showLimit(slave);
  showType(slave);
}

void SyncSettingsEditor::showLimit(const SlaveSettings& slave) {
  const QSignalBlocker quiet(limit_);
  const auto* family = families::find(slave.device);
  const auto* known = family != nullptr && family->error_limit ? &*family->error_limit : nullptr;
  limit_->clear();
  limit_->addItem(known != nullptr ? tr("As device (%1)").arg(known->usual) : tr("As device"), keys::unset());
  limit_->addItem(tr("0 (never gives up)"), QStringLiteral("0"));
  const int most = known != nullptr ? std::min(known->largest / kMissWeight, kMostMisses) : kMostMisses;
  for (int misses = 1; misses <= most; ++misses) {
    limit_->addItem(tr("%1 (%n miss(es) in a row)", "", misses).arg(misses * kMissWeight), QString::number(misses * kMissWeight));
  }
  choose(*limit_, slave.sync.error_limit ? QString::number(*slave.sync.error_limit) : keys::unset());
  limit_->setEnabled(slave.device.mailbox && slave.device.mailbox->coe);
}

void SyncSettingsEditor::showType(const SlaveSettings& slave) {
  const QSignalBlocker quiet(type_);
  type_->clear();
  type_->addItem(tr("As operation mode"), keys::unset());
  const std::pair<SyncTypeChoice, QString> types[] = {{SyncTypeChoice::kFreeRun, tr("Free run")},
                                                     {SyncTypeChoice::kSmEvent, tr("SM event")},
                                                     {SyncTypeChoice::kSync0, tr("SYNC0")},
                                                     {SyncTypeChoice::kSync1, tr("SYNC1")}};
  for (const auto& [type, text] : types) {
    auto asked = slave;
    asked.sync = {};
    asked.sync.type = type;
    const auto word = sync_type_name(type);
    if (check_sync_settings(asked)) type_->addItem(text, QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())));
  }
  const auto word = slave.sync.type ? sync_type_name(*slave.sync.type) : std::string_view("auto");
  choose(*type_, QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())));
  type_->setEnabled(type_->count() > 1);
}

}  // namespace syncline::ui
