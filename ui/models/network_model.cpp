// SPDX-License-Identifier: Apache-2.0
#include "ui/models/network_model.h"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "ui/text/glossary.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

// The master's index carries this id, a slave's carries kSlaveId.
constexpr quintptr kMasterId = 0;
constexpr quintptr kSlaveId = 1;

}  // namespace

NetworkModel::NetworkModel(QObject* parent) : QAbstractItemModel(parent) {}

void NetworkModel::setProject(const Project& project) {
  std::vector<Node> slaves;
  slaves.reserve(project.slaves.size());
  for (const auto& slave : project.slaves) {
    Node node;
    node.name = QString::fromStdString(slave.name);
    node.device = QString::fromStdString(slave.device.type);
    node.station_address = slave.station_address;
    slaves.push_back(std::move(node));
  }
  master_.name = QString::fromStdString(project.master.name);
  assign(std::move(slaves));
  Q_EMIT dataChanged(indexOf(-1), indexOf(-1));
}

void NetworkModel::assign(std::vector<Node> slaves) {
  const auto root = indexOf(-1);
  if (slaves.size() != slaves_.size()) {
    beginResetModel();
    slaves_ = std::move(slaves);
    endResetModel();
    return;
  }
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    slaves[i].al_status = slaves_[i].al_status;
    slaves[i].live_reference = slaves_[i].live_reference;
    slaves[i].dc = slaves_[i].dc;
    slaves[i].configured_reference = slaves_[i].configured_reference;
  }
  slaves_ = std::move(slaves);
  if (!slaves_.empty()) Q_EMIT dataChanged(index(0, 0, root), index(static_cast<int>(slaves_.size()) - 1, 0, root));
}

void NetworkModel::setConfiguration(const NetworkConfig* config) {
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const auto* dc =
        config != nullptr && i < config->slaves.size() && config->slaves[i].dc ? &*config->slaves[i].dc : nullptr;
    slaves_[i].dc = dc != nullptr;
    slaves_[i].configured_reference = dc != nullptr && dc->reference_clock;
  }
  if (!slaves_.empty()) Q_EMIT dataChanged(indexOf(0), indexOf(static_cast<int>(slaves_.size()) - 1));
}

void NetworkModel::setSnapshot(const Snapshot& snapshot) {
  const int master_state = snapshot.online ? static_cast<int>(snapshot.state) : -1;
  if (std::exchange(master_.al_status, master_state) != master_state) Q_EMIT dataChanged(indexOf(-1), indexOf(-1));
  int first = -1, last = -1;
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    auto& node = slaves_[i];
    const auto before = node;
    const SlaveStatus* status = snapshot.online && i < snapshot.slaves.size() ? &snapshot.slaves[i] : nullptr;
    node.al_status = status == nullptr ? -1 : (status->present ? status->al_status : 0);
    node.live_reference = status != nullptr && status->is_reference_clock;
    if (node == before) continue;
    if (first < 0) first = static_cast<int>(i);
    last = static_cast<int>(i);
  }
  if (first >= 0) Q_EMIT dataChanged(index(first, 0, indexOf(-1)), index(last, 0, indexOf(-1)));
}

QModelIndex NetworkModel::indexOf(int slave) const {
  if (slave < 0) return createIndex(0, 0, kMasterId);
  return slave < static_cast<int>(slaves_.size()) ? createIndex(slave, 0, kSlaveId) : QModelIndex();
}

QModelIndex NetworkModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? kSlaveId : kMasterId);
}

QModelIndex NetworkModel::parent(const QModelIndex& child) const {
  return child.isValid() && child.internalId() == kSlaveId ? indexOf(-1) : QModelIndex();
}

int NetworkModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return 1;
  return parent.internalId() == kMasterId && parent.column() == 0 ? static_cast<int>(slaves_.size()) : 0;
}

int NetworkModel::columnCount(const QModelIndex&) const { return 1; }

QVariant NetworkModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (section != 0 || orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return tr("Node");
}

QVariant NetworkModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (index.internalId() == kMasterId) return nodeData(master_, -1, role);
  return nodeData(slaves_[static_cast<std::size_t>(index.row())], index.row(), role);
}

QVariant NetworkModel::nodeData(const Node& node, int slave, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      return node.name;
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return toolTip(node, slave);
    case Qt::AccessibleTextRole: {
      if (node.al_status < 0) return node.name;
      const auto state = stateText(node, slave);
      return QStringLiteral("%1, %2").arg(node.name, state);
    }
    case kStateRole:
      return node.al_status < 0 ? -1 : static_cast<int>(al_state_of(static_cast<std::uint16_t>(node.al_status)));
    case kErrorRole:
      return node.al_status > 0 && (node.al_status & kAlErrorFlag) != 0;
    case kMarksRole: {
      QStringList marks;
      const bool online = node.al_status >= 0;
      if (online ? node.live_reference : node.configured_reference) marks << QStringLiteral("REF");
      if (node.dc) marks << QStringLiteral("DC");
      return marks;
    }
    case kSlaveRole:
      return slave;
    default:
      return {};
  }
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
