// SPDX-License-Identifier: Apache-2.0
#include "ui/models/network_model.h"

#include <QMimeData>
#include <QStringList>
#include <algorithm>
#include <map>
#include <utility>

#include "config/wiring_tree.h"
#include "ui/text/glossary.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

// The master's index carries this id, a slave's its position and one.
constexpr quintptr kMasterId = 0;

}  // namespace

NetworkModel::NetworkModel(QObject* parent) : QAbstractItemModel(parent) { arrange(); }

void NetworkModel::setProject(const Project& project) {
  const auto tree = WiringTree::of(project.slaves);
  std::vector<Node> slaves;
  std::vector<int> classic;
  slaves.reserve(project.slaves.size());
  for (const auto& slave : project.slaves) {
    Node node;
    node.name = QString::fromStdString(slave.name);
    node.device = QString::fromStdString(slave.device.type);
    node.group = QString::fromStdString(slave.hot_connect);
    node.optional = slave.optional;
    node.station_address = slave.station_address;
    // A line has one answer for all of its slaves; those before this one have theirs already.
    const auto position = slaves.size();
    const auto before = tree.previous(position);
    const bool goes_on = before && *before < position && tree.next(*before) == position;
    const auto from = goes_on ? std::nullopt : tree.branches_from(position);
    classic.push_back(goes_on ? classic[*before] : from ? static_cast<int>(*from) : -1);
    slaves.push_back(std::move(node));
  }
  master_.name = QString::fromStdString(project.master.name);
  assign(std::move(slaves), std::move(classic));
  Q_EMIT dataChanged(indexOf(-1), indexOf(-1));
}

void NetworkModel::assign(std::vector<Node> slaves, std::vector<int> classic) {
  const bool same_shape = slaves.size() == slaves_.size() && (shape_ == Shape::kFlat || classic == classic_);
  // One other address is an edit of a slave, several are slaves in other places.
  std::size_t others = 0;
  for (std::size_t i = 0; same_shape && i < slaves.size(); ++i)
    others += slaves[i].station_address == slaves_[i].station_address ? 0U : 1U;
  if (!same_shape || others > 1) {
    beginResetModel();
    slaves_ = std::move(slaves);
    classic_ = std::move(classic);
    arrange();
    endResetModel();
    return;
  }
  classic_ = std::move(classic);
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    slaves[i].al_status = slaves_[i].al_status;
    slaves[i].link = slaves_[i].link;
    slaves[i].live_reference = slaves_[i].live_reference;
    slaves[i].dc = slaves_[i].dc;
    slaves[i].configured_reference = slaves_[i].configured_reference;
  }
  std::vector<int> changed;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (!(slaves[i] == slaves_[i])) changed.push_back(static_cast<int>(i));
  }
  slaves_ = std::move(slaves);
  tellOf(changed);
}

void NetworkModel::setShape(Shape shape) {
  if (shape == shape_) return;
  beginResetModel();
  shape_ = shape;
  arrange();
  endResetModel();
}

void NetworkModel::arrange() {
  parents_ = shape_ == Shape::kClassic ? classic_ : std::vector<int>(slaves_.size(), -1);
  rows_.assign(slaves_.size(), 0);
  below_.assign(slaves_.size() + 1, {});
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    auto& siblings = below_[static_cast<std::size_t>(parents_[i] + 1)];
    rows_[i] = static_cast<int>(siblings.size());
    siblings.push_back(static_cast<int>(i));
  }
}

/// One range a parent.
void NetworkModel::tellOf(const std::vector<int>& changed) {
  std::map<int, std::pair<int, int>> ranges;
  for (const int slave : changed) {
    const auto at = static_cast<std::size_t>(slave);
    auto& [first, last] = ranges.try_emplace(parents_[at], rows_[at], rows_[at]).first->second;
    first = std::min(first, rows_[at]);
    last = std::max(last, rows_[at]);
  }
  for (const auto& [parent, range] : ranges)
    Q_EMIT dataChanged(index(range.first, 0, indexOf(parent)), index(range.second, 0, indexOf(parent)));
}

void NetworkModel::setConfiguration(const NetworkConfig* config) {
  std::vector<int> changed;
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const auto* dc =
        config != nullptr && i < config->slaves.size() && config->slaves[i].dc ? &*config->slaves[i].dc : nullptr;
    const bool leads = dc != nullptr && dc->reference_clock;
    if (slaves_[i].dc == (dc != nullptr) && slaves_[i].configured_reference == leads) continue;
    slaves_[i].dc = dc != nullptr;
    slaves_[i].configured_reference = leads;
    changed.push_back(static_cast<int>(i));
  }
  tellOf(changed);
}

void NetworkModel::setSnapshot(const Snapshot& snapshot, const std::vector<int>& positions) {
  const int master_state = snapshot.online ? static_cast<int>(snapshot.state) : -1;
  if (std::exchange(master_.al_status, master_state) != master_state) Q_EMIT dataChanged(indexOf(-1), indexOf(-1));
  std::vector<int> changed;
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    auto& node = slaves_[i];
    const auto at = i < positions.size() ? static_cast<std::size_t>(positions[i]) : snapshot.slaves.size();
    const SlaveStatus* status = snapshot.online && at < snapshot.slaves.size() ? &snapshot.slaves[at] : nullptr;
    const int al_status = status == nullptr ? -1 : (status->present ? status->al_status : 0);
    const bool leads = status != nullptr && status->is_reference_clock;
    const auto link = status == nullptr      ? LinkState::kOffline
                      : status->cable_broken ? LinkState::kBroken
                      : status->present      ? LinkState::kGood
                                             : LinkState::kSilent;
    if (node.al_status == al_status && node.live_reference == leads && node.link == link) continue;
    node.al_status = al_status;
    node.live_reference = leads;
    node.link = link;
    changed.push_back(static_cast<int>(i));
  }
  tellOf(changed);
}

QModelIndex NetworkModel::indexOf(int slave) const {
  if (slave < 0) return createIndex(0, 0, kMasterId);
  if (slave >= slaveCount()) return {};
  return createIndex(rows_[static_cast<std::size_t>(slave)], 0, static_cast<quintptr>(slave) + 1);
}

QModelIndex NetworkModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  if (!parent.isValid()) return indexOf(-1);
  return indexOf(below_[parent.internalId()][static_cast<std::size_t>(row)]);
}

QModelIndex NetworkModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == kMasterId) return {};
  return indexOf(parents_[child.internalId() - 1]);
}

int NetworkModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return 1;
  if (parent.column() != 0 || below_.empty()) return 0;
  return static_cast<int>(below_[parent.internalId()].size());
}

int NetworkModel::columnCount(const QModelIndex&) const { return 1; }

Qt::ItemFlags NetworkModel::flags(const QModelIndex& index) const {
  auto flags = QAbstractItemModel::flags(index);
  if (!index.isValid() || fixed_) return flags;
  flags |= Qt::ItemIsDropEnabled;
  return index.internalId() == kMasterId ? flags : flags | Qt::ItemIsDragEnabled;
}

QMimeData* NetworkModel::mimeData(const QModelIndexList& indexes) const {
  if (indexes.isEmpty() || indexes.front().internalId() == kMasterId) return nullptr;
  return draggedSlave(indexes.front().data(kAddressRole).toInt());
}

int NetworkModel::slaveAt(int address) const {
  const auto found = std::ranges::find(slaves_, address, [](const Node& node) { return int{node.station_address}; });
  return found == slaves_.end() ? -1 : static_cast<int>(found - slaves_.begin());
}

bool NetworkModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int, const QModelIndex&) const {
  if (fixed_ || data == nullptr) return false;
  const auto address = addressOf(*data);
  return address ? slaveAt(*address) >= 0 : deviceOf(*data).has_value();
}

DropPlace NetworkModel::placeOf(int row, const QModelIndex& parent) const {
  if (!parent.isValid()) return {slaveCount() - 1};
  if (row < 0) return {parent.data(kSlaveRole).toInt()};
  if (const auto lower = index(row, 0, parent); lower.isValid()) return {lower.data(kSlaveRole).toInt(), true};
  const auto upper = row > 0 ? index(rowCount(parent) - 1, 0, parent) : QModelIndex();
  return {(upper.isValid() ? upper : parent).data(kSlaveRole).toInt()};
}

bool NetworkModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                const QModelIndex& parent) {
  if (!canDropMimeData(data, action, row, column, parent)) return false;
  const auto place = placeOf(row, parent);
  if (const auto address = addressOf(*data)) {
    Q_EMIT slaveDropped(slaveAt(*address), place);
  } else if (const auto device = deviceOf(*data)) {
    Q_EMIT deviceDropped(device->id, place);
  }
  return true;
}

QVariant NetworkModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (section != 0 || orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return tr("Node");
}

QVariant NetworkModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (index.internalId() == kMasterId) return nodeData(master_, -1, role);
  const auto position = index.internalId() - 1;
  return nodeData(slaves_[position], static_cast<int>(position), role);
}

QVariant NetworkModel::nodeData(const Node& node, int slave, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      return node.name;
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return toolTip(node, slave);
    case Qt::AccessibleTextRole:
      return spokenText(node, slave);
    case kStateRole:
      return node.al_status < 0 ? -1 : static_cast<int>(al_state_of(static_cast<std::uint16_t>(node.al_status)));
    case kErrorRole:
      return node.al_status > 0 && (node.al_status & kAlErrorFlag) != 0;
    case kMarksRole:
      return marksOf(node);
    case kTopologyMarksRole: {
      auto marks = marksOf(node);
      if (!node.dc) marks << tr("no DC");
      if (!node.group.isEmpty()) marks << tr("HC");
      if (node.optional) marks << tr("opt.");
      return marks;
    }
    case kAddressRole:
      return node.station_address;
    case kLinkRole:
      return static_cast<int>(node.link);
    case kSlaveRole:
      return slave;
    default:
      return {};
  }
}

QStringList NetworkModel::marksOf(const Node& node) const {
  QStringList marks;
  const bool online = node.al_status >= 0;
  if (online ? node.live_reference : node.configured_reference) marks << QStringLiteral("REF");
  if (node.dc) marks << QStringLiteral("DC");
  return marks;
}

QString NetworkModel::spokenText(const Node& node, int slave) const {
  const auto text =
      slave < 0 ? node.name : tr("%1, position %2, address %3").arg(node.name).arg(slave).arg(node.station_address);
  return node.al_status < 0 ? text : joinedParts({text, stateText(node, slave)});
}

QString NetworkModel::stateText(const Node& node, int slave) {
  const auto state = al_state_of(static_cast<std::uint16_t>(node.al_status));
  return slave < 0 ? masterStateName(state) : stateName(state);
}

QString NetworkModel::toolTip(const Node& node, int slave) const {
  QStringList lines{node.name};
  if (slave >= 0) {
    lines = {QStringLiteral("%1 (%2)").arg(node.name, node.device),
             tr("Position %1, station address %2 (register 0x0010)").arg(slave).arg(node.station_address)};
    if (node.configured_reference) lines << tr("Reference clock of the project");
    if (node.dc) lines << tr("Distributed clocks on");
    if (!node.group.isEmpty()) lines << tr("Hot-connect group %1").arg(node.group);
    if (node.optional) lines << tr("Optional: may be missing");
    if (node.link == LinkState::kBroken) lines << tr("The cable to it is broken");
  }
  if (node.al_status >= 0) {
    const auto status = static_cast<std::uint16_t>(node.al_status);
    const bool read = slave >= 0 && status != 0;
    lines << (read ? tr("State %1 (register 0x0130 = %2)").arg(stateText(node, slave), hexText(status, 4))
                   : tr("State %1").arg(stateText(node, slave)));
  } else {
    lines << tr("Offline");
  }
  return lines.join(u'\n');
}

}  // namespace syncline::ui
