// SPDX-License-Identifier: Apache-2.0
#include "ui/models/pdo_model.h"

#include <QGuiApplication>
#include <QMimeData>
#include <QPalette>
#include <algorithm>
#include <iterator>
#include <utility>

#include "config/module_slots.h"
#include "config/pdo_sync_manager.h"
#include "config/slave_settings.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
PdoModel::PdoModel(PdoDirection direction, QObject* parent) : QAbstractTableModel(parent), direction_(direction) {}

void PdoModel::setSlave(const SlaveSettings& slave) {
  chosen_ = slave.assigned_pdos(direction_);
  std::vector<Row> rows;
  for (const auto& pdo : pdos_of(slave, direction_)) {  // those of its modules, too
    const bool chosen = std::ranges::find(chosen_, pdo.index) != chosen_.end();
    auto& row = rows.emplace_back(Row{effective_pdo(slave, pdo), chosen, {}});
    row.pdo.sync_manager = chosen ? sync_manager_of(slave, direction_, pdo) : std::nullopt;  // as the ENI says it
  }
  const bool same_rows = std::ranges::equal(
      rows, rows_, {}, [](const Row& row) { return row.pdo.index; }, [](const Row& row) { return row.pdo.index; });
  if (!same_rows) beginResetModel();
  rows_ = std::move(rows);
  for (auto& row : rows_) findRules(row);
  if (!same_rows) {
    endResetModel();
  } else if (!rows_.empty()) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  }
}

void PdoModel::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

const Pdo* PdoModel::pdo(int row) const {
  return row >= 0 && row < rowCount() ? &rows_[static_cast<std::size_t>(row)].pdo : nullptr;
}

std::uint32_t PdoModel::assignedBits() const {
  std::uint32_t bits = 0;
  for (const auto& row : rows_) bits += row.assigned ? row.pdo.bit_length() : 0;
  return bits;
}

/// Why it cannot be changed, or whose place it would take.
void PdoModel::findRules(Row& row) const {
  if (row.assigned) {
    if (row.pdo.mandatory) row.locked = tr("The device needs this PDO (Mandatory in the ESI)");
    return;
  }
  const auto excludes = [](const Pdo& one, std::uint16_t index) {
    return std::ranges::find(one.exclude, index) != one.exclude.end();
  };
  for (const auto& other : rows_) {
    if (!other.assigned || !(excludes(other.pdo, row.pdo.index) || excludes(row.pdo, other.pdo.index))) continue;
    if (other.pdo.mandatory) {
      row.locked = tr("Excluded by %1, which the device needs (Exclude and Mandatory in the ESI)")
                       .arg(hexText(other.pdo.index, 4));
      row.replaced.clear();
      return;
    }
    row.replaced.push_back(other.pdo.index);
  }
}

QString PdoModel::hint(const Row& row) const {
  if (!row.locked.isEmpty()) return row.locked;
  if (row.replaced.empty()) {
    return direction_ == PdoDirection::kRx ? tr("Assigned through object 0x1C12")
                                           : tr("Assigned through object 0x1C13");
  }
  QStringList names;
  for (const auto index : row.replaced) names << hexText(index, 4);
  return tr("Takes the place of %1: the device does not exchange both (Exclude in the ESI)")
      .arg(names.join(QStringLiteral(", ")));
}

int PdoModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int PdoModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant PdoModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column());
    case Qt::CheckStateRole:
      if (index.column() != kIndex) return {};
      return row.assigned ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole:
      return hint(row);
    case Qt::ForegroundRole:
      if (row.replaced.empty()) return {};
      return theme::mutedText(QGuiApplication::palette());
    case Qt::AccessibleDescriptionRole:
      return hint(row);
    case Qt::AccessibleTextRole:
      if (index.column() != kIndex) return {};
      return QStringLiteral("%1 %2").arg(hexText(row.pdo.index, 4), QString::fromStdString(row.pdo.name));
    case Qt::TextAlignmentRole:
      return index.column() == kSize ? int(Qt::AlignRight | Qt::AlignVCenter) : int(Qt::AlignLeft | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant PdoModel::text(const Row& row, int column) const {
  switch (column) {
    case kIndex:
      return hexText(row.pdo.index, 4);
    case kName:
      return QString::fromStdString(row.pdo.name);
    case kSyncManager:
      return row.pdo.sync_manager ? QStringLiteral("SM%1").arg(*row.pdo.sync_manager) : QStringLiteral("\u2013");
    case kSize:
      return bitsText(row.pdo.bit_length());
    default:
      return {};
  }
}

QVariant PdoModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return int((section == kSize ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kIndex:
      return tr("PDO");
    case kName:
      return tr("Name");
    case kSyncManager:
      return tr("SM");
    case kSize:
      return tr("Size");
    default:
      return {};
  }
}

Qt::ItemFlags PdoModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const auto& row = rows_[static_cast<std::size_t>(index.row())];
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  if (row.locked.isEmpty() || row.assigned) flags |= Qt::ItemIsEnabled;
  if (index.column() == kIndex && row.locked.isEmpty()) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

bool PdoModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::CheckStateRole || !(flags(index) & Qt::ItemIsUserCheckable)) return false;
  const auto& row = rows_[static_cast<std::size_t>(index.row())];
  const auto pdo = row.pdo.index;
  auto wanted = chosen_;
  std::erase(wanted, pdo);
  if (value.toInt() == Qt::Checked) {
    const auto is_replaced = [&](std::uint16_t one) {
      return std::ranges::find(row.replaced, one) != row.replaced.end();
    };
    // Where the first of them stood: the order is that of the process data.
    const auto place = std::ranges::find_if(wanted, is_replaced) - wanted.begin();
    std::erase_if(wanted, is_replaced);
    wanted.insert(wanted.begin() + std::min(place, std::ssize(wanted)), pdo);
  }
  Q_EMIT assignmentWanted(wanted);
  return true;
}

PdoEntryModel::PdoEntryModel(QObject* parent) : QAbstractTableModel(parent) {}

void PdoEntryModel::setEntries(std::vector<PdoEntry> entries) {
  if (entries == entries_) return;
  beginResetModel();
  entries_ = std::move(entries);
  offsets_.clear();
  std::uint32_t offset = 0;
  for (const auto& entry : entries_) {
    offsets_.push_back(offset);
    offset += entry.bit_length;
  }
  endResetModel();
}

Qt::ItemFlags PdoEntryModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return movable_ ? Qt::ItemIsDropEnabled : Qt::NoItemFlags;  // between the entries
  const auto flags = QAbstractTableModel::flags(index);
  return movable_ ? flags | Qt::ItemIsDragEnabled : flags;
}

QStringList PdoEntryModel::mimeTypes() const { return {QStringLiteral("application/x-syncline-pdo-entry")}; }

QMimeData* PdoEntryModel::mimeData(const QModelIndexList& indexes) const {
  if (indexes.isEmpty()) return nullptr;
  auto* data = new QMimeData;
  data->setData(mimeTypes().front(), QByteArray::number(indexes.front().row()));
  return data;
}

bool PdoEntryModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int,
                                 const QModelIndex& parent) {
  if (!movable_ || action != Qt::MoveAction || data == nullptr) return false;
  bool known = false;
  const int from = data->data(mimeTypes().front()).toInt(&known);
  if (!known || from < 0 || from >= rowCount()) return false;
  // On an entry: in its place; below all of them: behind the last.
  const int before = row >= 0 ? row : parent.isValid() ? parent.row() : rowCount();
  const int to = std::min(before > from ? before - 1 : before, rowCount() - 1);
  if (to != from) Q_EMIT moveWanted(from, to);
  return false;  // the view would take away what it thinks was copied
}

int PdoEntryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

int PdoEntryModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant PdoEntryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || role != Qt::DisplayRole) return {};
  const auto row = static_cast<std::size_t>(index.row());
  const auto& entry = entries_[row];
  switch (index.column()) {
    case kOffset:
      return QStringLiteral("%1.%2").arg(offsets_[row] / 8).arg(offsets_[row] % 8);
    case kObject:
      return entry.index == 0 ? QStringLiteral("\u2013") : objectText(entry.index, entry.sub_index);
    case kName:
      return entry.index == 0 ? tr("(padding)") : QString::fromStdString(entry.name);
    case kType:
      return QString::fromStdString(entry.data_type);
    case kLength:
      return bitsText(entry.bit_length);
    default:
      return {};
  }
}

QVariant PdoEntryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kOffset:
      return tr("Offset");
    case kObject:
      return tr("Object");
    case kName:
      return tr("Entry");
    case kType:
      return tr("Type");
    case kLength:
      return tr("Size");
    default:
      return {};
  }
}

}  // namespace syncline::ui
