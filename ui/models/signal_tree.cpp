// SPDX-License-Identifier: Apache-2.0
#include "ui/models/signal_tree.h"

#include <QObject>

#include "record/run_record.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/view_signals.h"
#include "ui/text/joined_text.h"
#include "ui/text/quality_text.h"
#include "ui/text/signal_text.h"

namespace syncline::ui {
namespace {

constexpr int kNumberRole = Qt::UserRole + 2;

QStandardItem* groupItem(const QString& text) {
  auto* item = new QStandardItem(text);
  item->setEditable(false);
  item->setData(text, SignalTree::kWordsRole);
  item->setSelectable(false);
  return item;
}

/// Not asked for a derived series, which would be made now.
bool hasValues(const RunRecord& record, const SignalInfo& row, std::size_t slave) {
  if (row.form == SignalInfo::Form::kDerived) return record.samples().sync0(slave).period > 0;
  return !seriesOf(record, {row.id, slave}).empty();
}

/// At the end of what is shown.
QString qualityOf(const RunRecord& record, const ViewSignal& signal) {
  const auto source = sourceOf(record, signal);
  if (!source) return {};
  const auto& store = record.samples();
  return qualityText(quality_of(store, source->signal, source->slave, store.last_time()));
}

}  // namespace

SignalTree::SignalTree(const RunRecord& record, QObject* parent) : QStandardItemModel(parent) {
  using Scope = SignalInfo::Scope;
  auto* bus = groupItem(tr("Bus"));
  for (const auto& row : signals()) {
    if (row.form == SignalInfo::Form::kCell || row.scope != Scope::kBus) continue;
    addSignal(*bus, record, viewSignalOf(record, {row.id, 0}), hasValues(record, row, 0));
  }
  appendRow(bus);
  for (std::size_t slave = 0; slave < record.samples().slave_count(); ++slave) {
    QStandardItem* group = nullptr;
    for (const auto& row : signals()) {
      if (row.scope != Scope::kSlave || row.form == SignalInfo::Form::kCell) continue;
      const auto signal = viewSignalOf(record, {row.id, slave});
      if (group == nullptr) group = groupItem(ownerOf(record, signal));
      addSignal(*group, record, signal, hasValues(record, row, slave));
    }
    if (group != nullptr) appendRow(group);
  }
  const auto& variables = record.watched().variables();
  if (variables.empty()) return;
  auto* group = groupItem(tr("Variables of the process image"));
  for (std::size_t number = 0; number < variables.size(); ++number)
    addSignal(*group, record, viewSignalOf(record, {Signal::kVariable, number}), true);
  appendRow(group);
}

void SignalTree::addSignal(QStandardItem& group, const RunRecord& record, const ViewSignal& signal, bool any) {
  const auto name = quantityOf(signal);
  auto* item = new QStandardItem(any ? name : tr("%1 (no values so far)").arg(name));
  item->setEditable(false);
  const auto key = QString::fromStdString(signal.key);
  item->setData(ownerOf(record, signal) + u' ' + name + u' ' + key, kWordsRole);
  item->setData(static_cast<int>(signals_.size()), kNumberRole);
  item->setToolTip(any ? joinedSentences({key, qualityOf(record, signal)}) : key);
  signals_.push_back(signal);
  group.appendRow(item);
}

std::optional<ViewSignal> SignalTree::signalAt(const QModelIndex& index) const {
  const auto number = index.data(kNumberRole);
  if (!number.isValid()) return std::nullopt;
  return signals_[static_cast<std::size_t>(number.toInt())];
}

}  // namespace syncline::ui
