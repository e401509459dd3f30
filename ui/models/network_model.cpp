// SPDX-License-Identifier: Apache-2.0
#include "ui/models/network_model.h"

#include <QFont>
#include <QMimeData>
#include <algorithm>
#include <map>
#include <utility>

#include "config/project.h"
#include "ui/text/glossary.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

/// What an index carries: the network, and a slave's position and one, of the master 0.
quintptr idOf(int network, int slave) {
  return static_cast<quintptr>(network) << 32U | static_cast<quintptr>(slave + 1);
}
int networkIn(const QModelIndex& index) { return static_cast<int>(index.internalId() >> 32U); }
int slaveIn(const QModelIndex& index) { return static_cast<int>(index.internalId() & 0xFFFF'FFFFU) - 1; }

}  // namespace

NetworkModel::NetworkModel(QObject* parent) : QAbstractItemModel(parent) {}

void NetworkModel::setProject(const Project& project) {
  NodeTree next(project, shape_);
  auto& now = trees_[in_work_];
  if (!next.stands_like(now)) {
    beginResetModel();
    now = std::move(next);
    endResetModel();
    return;
  }
  next.take_states(now);
  const auto changed = next.different_from(now);
  now = std::move(next);
  tellOf(network(), changed);
}

/// A network that was there and stands as it stood keeps its states, whoever is in work.
void NetworkModel::setNetworks(const QStringList& names, const std::vector<const Project*>& projects, int in_work) {
  std::vector<NodeTree> trees;
  for (const auto* project : projects) trees.emplace_back(*project, shape_);
  bool same = trees.size() == trees_.size() && in_work == network();
  for (std::size_t i = 0; i < trees.size() && i < trees_.size(); ++i) {
    const bool alike = trees[i].stands_like(trees_[i]);
    same = same && alike;
    if (alike) trees[i].take_states(trees_[i]);
  }
  if (!same) beginResetModel();
  std::swap(trees_, trees);
  in_work_ = static_cast<std::size_t>(in_work);
  names_ = names;
  if (!same) return endResetModel();
  for (int i = 0; i < networkCount(); ++i) {
    auto changed = trees_[static_cast<std::size_t>(i)].different_from(trees[static_cast<std::size_t>(i)]);
    changed.push_back(-1);  // its name is not the tree's
    tellOf(i, changed);
  }
}

void NetworkModel::setShape(Shape shape) {
  if (shape == shape_) return;
  beginResetModel();
  shape_ = shape;
  for (auto& tree : trees_) tree.arrange(shape);
  endResetModel();
}

/// One range a parent.
void NetworkModel::tellOf(int network, const std::vector<int>& changed) {
  const auto& tree = trees_[static_cast<std::size_t>(network)];
  std::map<int, std::pair<int, int>> ranges;
  for (const int slave : changed) {
    if (slave < 0) {
      Q_EMIT dataChanged(indexOf(network, -1), indexOf(network, -1));
      continue;
    }
    const int row = tree.row(slave);
    auto& [first, last] = ranges.try_emplace(tree.parent(slave), row, row).first->second;
    first = std::min(first, row);
    last = std::max(last, row);
  }
  for (const auto& [parent, range] : ranges) {
    const auto above = indexOf(network, parent);
    Q_EMIT dataChanged(index(range.first, 0, above), index(range.second, 0, above));
  }
}

void NetworkModel::setConfiguration(int network, const NetworkConfig* config) {
  if (network < 0 || network >= networkCount()) return;
  tellOf(network, trees_[static_cast<std::size_t>(network)].set_configuration(config));
}

void NetworkModel::setSnapshot(const Snapshot& snapshot, const std::vector<int>& positions) {
  setSnapshot(network(), snapshot, positions);
}

void NetworkModel::setSnapshot(int network, const Snapshot& snapshot, const std::vector<int>& positions) {
  if (network < 0 || network >= networkCount()) return;
  tellOf(network, trees_[static_cast<std::size_t>(network)].set_snapshot(snapshot, positions));
}

QModelIndex NetworkModel::indexOf(int network, int slave) const {
  if (network < 0 || network >= networkCount()) return {};
  const auto& tree = trees_[static_cast<std::size_t>(network)];
  if (slave < 0) return createIndex(network, 0, idOf(network, -1));
  if (slave >= tree.size()) return {};
  return createIndex(tree.row(slave), 0, idOf(network, slave));
}

QModelIndex NetworkModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  if (!parent.isValid()) return indexOf(row, -1);
  const int network = networkIn(parent);
  const auto& below = trees_[static_cast<std::size_t>(network)].below(slaveIn(parent));
  return indexOf(network, below[static_cast<std::size_t>(row)]);
}

QModelIndex NetworkModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || slaveIn(child) < 0) return {};
  const int network = networkIn(child);
  return indexOf(network, trees_[static_cast<std::size_t>(network)].parent(slaveIn(child)));
}

int NetworkModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return networkCount();
  if (parent.column() != 0) return 0;
  return static_cast<int>(trees_[static_cast<std::size_t>(networkIn(parent))].below(slaveIn(parent)).size());
}

int NetworkModel::columnCount(const QModelIndex&) const { return 1; }

Qt::ItemFlags NetworkModel::flags(const QModelIndex& index) const {
  auto flags = QAbstractItemModel::flags(index);
  // No row: the free room below them all.
  if (fixed_ || (index.isValid() && networkIn(index) != network())) return flags;
  flags |= Qt::ItemIsDropEnabled;
  return !index.isValid() || slaveIn(index) < 0 ? flags : flags | Qt::ItemIsDragEnabled;
}

QMimeData* NetworkModel::mimeData(const QModelIndexList& indexes) const {
  if (indexes.isEmpty() || slaveIn(indexes.front()) < 0) return nullptr;
  return draggedSlave(indexes.front().data(kAddressRole).toInt());
}

bool NetworkModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int, const QModelIndex& parent) const {
  if (fixed_ || data == nullptr || (parent.isValid() && networkIn(parent) != network())) return false;
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
  const int network = networkIn(index), slave = slaveIn(index);
  if (role == kNetworkRole) return network;
  if (role == kOtherRole) return network != this->network();
  if (slave < 0 && networkCount() > 1) {
    if (const auto own = masterData(network, role); own.isValid()) return own;
  }
  return nodeData(trees_[static_cast<std::size_t>(network)].node(slave), slave, role);
}

/// A master among several goes by the name of its network; the one in work stands out.
QVariant NetworkModel::masterData(int network, int role) const {
  if (role == Qt::DisplayRole) return names_.value(network);
  if (role == Qt::FontRole && network == this->network()) {
    QFont bold;
    bold.setBold(true);
    return bold;
  }
  if (role != Qt::AccessibleTextRole) return {};
  const auto& master = trees_[static_cast<std::size_t>(network)].node(-1);
  const auto text = network == this->network() ? tr("%1, network in work").arg(names_.value(network))
                                               : tr("%1, another network").arg(names_.value(network));
  return master.al_status < 0 ? text : joinedParts({text, stateText(master, -1)});
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
