// SPDX-License-Identifier: Apache-2.0
#include "ui/models/register_model.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>
#include <algorithm>

#include "support/le_number.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"

namespace syncline::ui {

RegisterModel::RegisterModel(QObject* parent) : GroupedModel(parent) { setUnits(8, 8); }

void RegisterModel::setUnits(unsigned fmmus, unsigned sync_managers) {
  beginResetModel();
  layouts_ = reg::register_layouts(fmmus, sync_managers);
  readings_.assign(layouts_.size(), {});
  endResetModel();
}

/// Of all registers that lie in there.
template <class Change>
void RegisterModel::change(std::uint16_t address, std::size_t length, Change apply) {
  const auto first = std::ranges::lower_bound(layouts_, address, {}, &reg::RegisterLayout::address);
  auto at = first;
  for (; at != layouts_.end() && static_cast<std::size_t>(at->address) + at->length <= address + length; ++at) {
    const auto row = static_cast<int>(at - layouts_.begin());
    apply(*at, readings_[static_cast<std::size_t>(row)]);
    const auto top = index(row, 0);
    if (const int fields = rowCount(top); fields > 0)
      Q_EMIT dataChanged(index(0, kValue, top), index(fields - 1, kDigits, top));
  }
  if (at == first) return;
  Q_EMIT dataChanged(index(static_cast<int>(first - layouts_.begin()), kValue),
                     index(static_cast<int>(at - layouts_.begin()) - 1, kAge));
}

void RegisterModel::setValues(std::uint16_t address, const std::vector<std::uint8_t>& bytes, Nanoseconds time) {
  change(address, bytes.size(), [&](const reg::RegisterLayout& layout, Reading& reading) {
    const auto begin = bytes.begin() + (layout.address - address);
    reading = {{begin, begin + layout.length}, time, {}};
  });
}

void RegisterModel::setFailure(std::uint16_t address, std::uint16_t length, const QString& why) {
  change(address, length, [&](const reg::RegisterLayout&, Reading& reading) { reading = {{}, 0, why}; });
}

void RegisterModel::setNow(std::optional<Nanoseconds> now) {
  if (!now && !now_) return;
  now_ = now;
  Q_EMIT dataChanged(index(0, kAge), index(rowCount() - 1, kAge));
}

const reg::RegisterLayout* RegisterModel::layout(const QModelIndex& index) const {
  if (!index.isValid()) return nullptr;
  return &layouts_[groupOf(index)];
}

std::vector<std::uint8_t> RegisterModel::value(std::uint16_t address) const {
  const auto at = std::ranges::lower_bound(layouts_, address, {}, &reg::RegisterLayout::address);
  if (at == layouts_.end() || at->address != address) return {};
  return readings_[static_cast<std::size_t>(at - layouts_.begin())].bytes;
}

// ---- the tree -----------------------------------------------------------------------------------

int RegisterModel::columnCount(const QModelIndex&) const { return kColumnCount; }

QVariant RegisterModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString titles[kColumnCount] = {tr("Address"), tr("Register"), tr("Value"), tr("Hex"), tr("Age")};
  return titles[section];
}

QString RegisterModel::fieldText(const reg::RegisterLayout& layout, int field, int column) const {
  const auto& one = layout.fields[static_cast<std::size_t>(field)];
  const auto& reading = readings_[static_cast<std::size_t>(&layout - layouts_.data())];
  switch (column) {
    case kAddress:
      return one.width == 1 ? QStringLiteral(".%1").arg(one.bit)
                            : QStringLiteral(".%1:%2").arg(one.bit + one.width - 1).arg(one.bit);
    case kName:
      return fromView(one.name);
    case kValue:
      return reading.bytes.empty() ? QString() : QString::fromStdString(reg::field_text(one, reading.bytes));
    default:
      return {};
  }
}

QString RegisterModel::text(const QModelIndex& index) const {
  const auto& one = *layout(index);
  if (memberOf(index)) return fieldText(one, index.row(), index.column());
  const auto& reading = readings_[static_cast<std::size_t>(index.row())];
  switch (index.column()) {
    case kAddress:
      return hexText(one.address, 4);
    case kName:
      return QString::fromStdString(one.name);
    case kValue:
      if (!reading.failure.isEmpty()) return reading.failure;
      return reading.bytes.empty() ? QString() : QString::fromStdString(reg::register_text(one, reading.bytes));
    case kDigits:
      return reading.bytes.empty() ? QString() : hexText(le_number(reading.bytes), 2 * one.length);
    case kAge:
      if (reading.bytes.empty()) return {};
      if (!now_) return tr("last run");
      return tr("%1 s").arg(
          QLocale().toString(static_cast<double>(std::max<Nanoseconds>(*now_ - reading.time, 0)) / 1e9, 'f', 1));
    default:
      return {};
  }
}

QVariant RegisterModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& one = *layout(index);
  const bool top = !memberOf(index);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return text(index);
    case Qt::ToolTipRole: {
      const auto group = fromView(reg::register_group_name(one.group));
      const auto what =
          QStringLiteral("%1 %2 (%3)").arg(hexText(one.address, 4), QString::fromStdString(one.name), group);
      const auto shown = text(index);
      return shown.isEmpty() || index.column() <= kName ? what : QStringLiteral("%1\n%2").arg(what, shown);
    }
    case Qt::ForegroundRole:
      if (!top || index.column() != kValue || readings_[static_cast<std::size_t>(index.row())].failure.isEmpty())
        return {};
      return theme::mutedText(QGuiApplication::palette());
    case kGroupRole:
      return static_cast<int>(one.group);
    case kAddressRole:
      return one.address;
    case kWordsRole:
      return hexText(one.address, 4) + u' ' + QString::fromStdString(one.name) + u' ' +
             fromView(reg::register_group_name(one.group)) + u' ' +
             (top ? QString() : text(index.siblingAtColumn(kName)));
    default:
      return {};
  }
}

}  // namespace syncline::ui
