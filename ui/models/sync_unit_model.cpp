// SPDX-License-Identifier: Apache-2.0
#include "ui/models/sync_unit_model.h"

#include <QMimeData>
#include <algorithm>
#include <utility>

#include "config/project.h"
#include "ui/models/dragged.h"
#include "ui/text/glossary.h"

namespace syncline::ui {

SyncUnitModel::SyncUnitModel(QObject* parent) : GroupedModel(parent) {}

void SyncUnitModel::setProject(const Project& project) {
  std::vector<Unit> units(1);
  for (const auto& unit : project.master.sync_units) units.push_back({QString::fromStdString(unit.name), {}});
  const auto add = [&units](const std::string& name, const UnitMember& member) {
    const auto found = std::ranges::find(units, QString::fromStdString(name), &Unit::name);
    if (found != units.end()) found->members.push_back(member);
  };
  std::vector<QString> names;
  for (const auto& slave : project.slaves) {
    const int position = static_cast<int>(names.size());
    names.push_back(nodeName(project, position));
    const bool outputs = !slave.assigned_rx_pdos.empty() || !slave.output_unit.empty();
    const bool inputs = !slave.assigned_tx_pdos.empty() || !slave.input_unit.empty();
    if (outputs && inputs && slave.output_unit == slave.input_unit) {
      add(slave.output_unit, {position, slave.station_address, true, true});
      continue;
    }
    if (outputs) add(slave.output_unit, {position, slave.station_address, true, false});
    if (inputs) add(slave.input_unit, {position, slave.station_address, false, true});
  }
  if (units == units_ && names == names_) return;
  beginResetModel();
  units_ = std::move(units);
  names_ = std::move(names);
  endResetModel();
}

const UnitMember* SyncUnitModel::member(const QModelIndex& index) const {
  const auto row = index.isValid() ? memberOf(index) : std::nullopt;
  return row ? &units_[groupOf(index)].members[*row] : nullptr;
}

QString SyncUnitModel::unit(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  return units_[groupOf(index)].name;
}

QModelIndexList SyncUnitModel::find(int address) const {
  QModelIndexList found;
  for (std::size_t unit = 0; unit < units_.size(); ++unit) {
    const auto& members = units_[unit].members;
    for (std::size_t row = 0; row < members.size(); ++row) {
      if (members[row].address == address) found << index(static_cast<int>(row), 0, index(static_cast<int>(unit), 0));
    }
  }
  return found;
}

int SyncUnitModel::columnCount(const QModelIndex&) const { return kColumns; }

QVariant SyncUnitModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == kSlave ? tr("Sync Unit, slave") : tr("Process data");
}

QVariant SyncUnitModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || role != Qt::DisplayRole) return {};
  if (const auto* of = member(index)) {
    if (index.column() == kSlave) return names_[static_cast<std::size_t>(of->slave)];
    return of->outputs && of->inputs ? tr("Outputs and inputs") : of->outputs ? tr("Outputs") : tr("Inputs");
  }
  const auto& [name, members] = units_[static_cast<std::size_t>(index.row())];
  if (index.column() == kSlave) return name.isEmpty() ? tr("None (base task)") : name;
  return tr("%n slave(s)", nullptr, static_cast<int>(members.size()));
}

Qt::ItemFlags SyncUnitModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const auto flags = QAbstractItemModel::flags(index) | Qt::ItemIsDropEnabled;
  return member(index) != nullptr ? flags | Qt::ItemIsDragEnabled : flags;
}

QStringList SyncUnitModel::mimeTypes() const { return {kUnitMembersMime}; }

QMimeData* SyncUnitModel::mimeData(const QModelIndexList& indexes) const {
  std::vector<DraggedMember> members;
  for (const auto& index : indexes) {
    const auto* of = member(index);
    if (of != nullptr && index.column() == kSlave) members.push_back({of->address, of->outputs, of->inputs});
  }
  return members.empty() ? nullptr : draggedMembers(members);
}

/// Slaves that have gone meanwhile are left out.
std::vector<UnitMember> SyncUnitModel::dragged(const QMimeData& data) const {
  std::vector<UnitMember> members;
  for (const auto& [address, outputs, inputs] : membersOf(data)) {
    const auto rows = find(address);
    if (!rows.isEmpty()) members.push_back({member(rows.front())->slave, address, outputs, inputs});
  }
  return members;
}

bool SyncUnitModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int, const QModelIndex& parent) const {
  return data != nullptr && parent.isValid() && !dragged(*data).empty();
}

bool SyncUnitModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                 const QModelIndex& parent) {
  if (!canDropMimeData(data, action, row, column, parent)) return false;
  Q_EMIT moveWanted(dragged(*data), unit(parent));
  return true;
}

}  // namespace syncline::ui
