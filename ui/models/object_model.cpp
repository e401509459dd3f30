// SPDX-License-Identifier: Apache-2.0
#include "ui/models/object_model.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <utility>

#include "ui/text/units.h"
#include "ui/theme/theme.h"

namespace syncline::ui {

ObjectModel::ObjectModel(QObject* parent) : GroupedModel(parent) {}

void ObjectModel::setDictionary(Dictionary dictionary) {
  beginResetModel();
  dictionary_ = std::move(dictionary);
  endResetModel();
}

void ObjectModel::clearValues() {
  beginResetModel();
  std::erase_if(readings_, [](const auto& one) { return !one.second.watched; });
  for (auto& [address, reading] : readings_) reading = {.watched = true};
  endResetModel();
}

void ObjectModel::setObject(DictionaryObject object) {
  const auto at = std::ranges::lower_bound(dictionary_, object.index, {}, &DictionaryObject::index);
  const auto row = static_cast<int>(at - dictionary_.begin());
  if (at == dictionary_.end() || at->index != object.index) {
    beginInsertRows({}, row, row);
    dictionary_.insert(at, std::move(object));
    endInsertRows();
    return;
  }
  const auto top = index(row, 0);
  if (const int gone = rowCount(top); gone > 0) {
    beginRemoveRows(top, 0, gone - 1);
    at->entries.clear();
    endRemoveRows();
  }
  at->entries.clear();
  if (!object.single && !object.entries.empty()) {
    beginInsertRows(top, 0, static_cast<int>(object.entries.size()) - 1);
    *at = std::move(object);
    endInsertRows();
  } else {
    *at = std::move(object);
  }
  Q_EMIT dataChanged(top, top.siblingAtColumn(kColumnCount - 1));
}

void ObjectModel::setValue(coe::ObjectAddress object, std::vector<std::uint8_t> bytes, Nanoseconds time) {
  auto& reading = readings_[key(object)];
  reading.bytes = std::move(bytes);
  reading.time = time;
  reading.failure.clear();
  tell(object);
}

void ObjectModel::setFailure(coe::ObjectAddress object, const QString& why) {
  readings_[key(object)].failure = why;
  tell(object);
}

void ObjectModel::tell(coe::ObjectAddress object) {
  const auto at = find(object);
  if (at.isValid()) Q_EMIT dataChanged(at, at.siblingAtColumn(kColumnCount - 1));
}

void ObjectModel::setWatched(const std::vector<coe::ObjectAddress>& objects) {
  for (auto& [address, reading] : readings_) reading.watched = false;
  for (const auto object : objects) readings_[key(object)].watched = true;
  if (dictionary_.empty()) return;
  for (int row = 0; row < rowCount(); ++row) {
    const auto top = index(row, 0);
    if (const int entries = rowCount(top); entries > 0)
      Q_EMIT dataChanged(index(0, 0, top), index(entries - 1, 0, top), {Qt::CheckStateRole});
  }
  Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, 0), {Qt::CheckStateRole});
}

std::vector<coe::ObjectAddress> ObjectModel::watched() const {
  std::vector<coe::ObjectAddress> all;
  for (const auto& [address, reading] : readings_) {
    if (reading.watched) all.push_back({static_cast<std::uint16_t>(address >> 8), static_cast<std::uint8_t>(address)});
  }
  return all;
}

const ObjectModel::Reading* ObjectModel::reading(coe::ObjectAddress object) const {
  const auto found = readings_.find(key(object));
  return found == readings_.end() ? nullptr : &found->second;
}

std::vector<std::uint8_t> ObjectModel::value(coe::ObjectAddress object) const {
  const auto* known = reading(object);
  return known == nullptr ? std::vector<std::uint8_t>{} : known->bytes;
}

const DictionaryEntry* ObjectModel::entry(const QModelIndex& index) const {
  if (!index.isValid()) return nullptr;
  if (const auto member = memberOf(index)) return &dictionary_[groupOf(index)].entries[*member];
  const auto& object = dictionary_[static_cast<std::size_t>(index.row())];
  return object.single && !object.entries.empty() ? &object.entries.front() : nullptr;
}

coe::ObjectAddress ObjectModel::address(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const auto at = groupOf(index);
  const auto* one = entry(index);
  return {dictionary_[at].index, one == nullptr ? std::uint8_t{0} : one->sub_index};
}

QModelIndex ObjectModel::find(coe::ObjectAddress object, int column) const {
  const auto at = std::ranges::lower_bound(dictionary_, object.index, {}, &DictionaryObject::index);
  if (at == dictionary_.end() || at->index != object.index) return {};
  const auto top = index(static_cast<int>(at - dictionary_.begin()), column);
  if (at->single) return object.sub_index == 0 ? top : QModelIndex();
  const auto entry = std::ranges::find(at->entries, object.sub_index, &DictionaryEntry::sub_index);
  if (entry == at->entries.end()) return {};
  return index(static_cast<int>(entry - at->entries.begin()), column, top.siblingAtColumn(0));
}

// ---- the tree -----------------------------------------------------------------------------------

int ObjectModel::members(std::size_t group) const {
  const auto& object = dictionary_[group];
  return object.single ? 0 : static_cast<int>(object.entries.size());
}

int ObjectModel::columnCount(const QModelIndex&) const { return kColumnCount; }

Qt::ItemFlags ObjectModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Qt::ItemFlags all = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return index.column() == kObject && entry(index) != nullptr ? all | Qt::ItemIsUserCheckable : all;
}

QVariant ObjectModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::ToolTipRole && section == kObject) return tr("Ticked entries are watched");
  if (role != Qt::DisplayRole) return {};
  const QString titles[kColumnCount] = {tr("Object"), tr("Name"),  tr("Type"), tr("Access"),
                                        tr("Unit"),   tr("Value"), tr("Hex")};
  return titles[section];
}

QVariant ObjectModel::text(const QModelIndex& index) const {
  const auto* one = entry(index);
  const bool top = !memberOf(index);
  const auto& object = dictionary_[groupOf(index)];
  const auto address = this->address(index);
  switch (index.column()) {
    case kObject:
      if (one == nullptr || top) return hexText(object.index, 4);
      return QStringLiteral(":") + hexText(one->sub_index, 2).mid(2);
    case kName:
      return top ? object.name : one->name;
    case kType:
      return one == nullptr ? QString() : one->type_name;
    case kAccess:
      return one == nullptr ? QString() : accessText(*one);
    case kUnit:
      return one == nullptr || one->unit == 0 ? QString() : hexText(one->unit, 4);
    case kValue:
    case kRaw: {
      if (one == nullptr) return {};
      const auto* known = reading(address);
      if (known != nullptr && !known->failure.isEmpty()) return index.column() == kValue ? known->failure : QString();
      const auto& bytes = known != nullptr && !known->bytes.empty() ? known->bytes : one->default_value;
      return index.column() == kValue ? valueText(*one, bytes) : rawText(*one, bytes);
    }
    default:
      return {};
  }
}

QVariant ObjectModel::toolTip(const QModelIndex& index) const {
  const auto* one = entry(index);
  if (one == nullptr) return text(index);
  const auto* known = reading(address(index));
  const auto shown = text(index).toString();
  if (index.column() != kValue && index.column() != kRaw) return shown;
  if (known != nullptr && !known->failure.isEmpty()) return known->failure;
  if (known != nullptr && !known->bytes.empty()) return tr("%1, read from the slave").arg(shown);
  return one->default_value.empty() ? tr("Not read yet") : tr("%1, the default: not read yet").arg(shown);
}

QVariant ObjectModel::exportText(const QModelIndex& index) const {
  if (index.column() != kValue && index.column() != kRaw) return text(index);
  const auto* known = entry(index) == nullptr ? nullptr : reading(address(index));
  const bool read = known != nullptr && (!known->bytes.empty() || !known->failure.isEmpty());
  return read ? text(index) : QVariant();
}

QVariant ObjectModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto* one = entry(index);
  const auto* known = one == nullptr ? nullptr : reading(address(index));
  const bool live = index.column() == kValue || index.column() == kRaw;
  switch (role) {
    case Qt::DisplayRole:
      return text(index);
    case Qt::ToolTipRole:
      return toolTip(index);
    case Qt::AccessibleTextRole:
      return live && one != nullptr ? toolTip(index) : text(index);
    case Qt::CheckStateRole:
      if (index.column() != kObject || one == nullptr) return {};
      return known != nullptr && known->watched ? Qt::Checked : Qt::Unchecked;
    case Qt::ForegroundRole: {
      if (!live || one == nullptr) return {};
      const auto palette = QGuiApplication::palette();
      if (known != nullptr && !known->failure.isEmpty()) return theme::toneColor(palette, theme::Tone::kBad);
      return known != nullptr && !known->bytes.empty() ? QVariant() : QVariant(theme::mutedText(palette));
    }
    case kExportRole:
      return exportText(index);
    case kDefaultRole:
      return one == nullptr ? QVariant() : QVariant(valueText(*one, one->default_value));
    case kWatchedRole:
      return known != nullptr && known->watched;
    case kWordsRole: {
      QString words = objectText(address(index));
      for (int column = kName; column < kColumnCount; ++column)
        words += u' ' + text(index.siblingAtColumn(column)).toString();
      return !memberOf(index) ? words : words + u' ' + text(index.parent().siblingAtColumn(kName)).toString();
    }
    default:
      return {};
  }
}

bool ObjectModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != kObject || entry(index) == nullptr) return false;
  readings_[key(address(index))].watched = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
  Q_EMIT watchedChanged();
  return true;
}

}  // namespace syncline::ui
