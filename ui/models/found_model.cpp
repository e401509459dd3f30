// SPDX-License-Identifier: Apache-2.0
#include "ui/models/found_model.h"

#include <algorithm>

#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString deviceText(const SlaveSettings& slave) {
  return QString::fromStdString(slave.device.type.empty() ? slave.device.name : slave.device.type);
}

QString kindText(FoundKind kind) {
  switch (kind) {
    case FoundKind::kMatched:
      return FoundModel::tr("Matches");
    case FoundKind::kRewired:
      return FoundModel::tr("Wired otherwise");
    case FoundKind::kMoved:
      return FoundModel::tr("Moved");
    case FoundKind::kRevision:
      return FoundModel::tr("Other revision");
    case FoundKind::kOtherDevice:
      return FoundModel::tr("Other device");
    case FoundKind::kMissing:
      return FoundModel::tr("Missing");
    case FoundKind::kExtra:
      return FoundModel::tr("Additional");
  }
  return {};
}

QString wiring(const Project& project, const SlaveSettings& slave) {
  if (!slave.previous || slave.previous->position >= project.slaves.size()) return FoundModel::tr("the master");
  return FoundModel::tr("slave %1, port %2").arg(slave.previous->position).arg(QChar(u'A' + slave.previous->port));
}

}  // namespace

FoundModel::FoundModel(const Project& ours, const Project& found, QObject* parent)
    : QAbstractTableModel(parent), ours_(ours), found_(found), lines_(compare_found(ours, found)) {
  for (const auto& line : lines_) ticked_.push_back(line.kind != FoundKind::kMatched);
}

int FoundModel::count(FoundKind kind) const {
  return static_cast<int>(std::ranges::count(lines_, kind, &FoundSlave::kind));
}

int FoundModel::tickedCount() const { return static_cast<int>(std::ranges::count(ticked_, true)); }

int FoundModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int FoundModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString FoundModel::difference(const FoundSlave& line) const {
  const auto* ours = line.ours ? &ours_.slaves[*line.ours] : nullptr;
  const auto* found = line.found ? &found_.slaves[*line.found] : nullptr;
  switch (line.kind) {
    case FoundKind::kMatched:
      return {};
    case FoundKind::kRewired:
      return tr("Connected to %1; in the project to %2").arg(wiring(found_, *found), wiring(ours_, *ours));
    case FoundKind::kMoved:
      return tr("At position %1; in the project at %2").arg(*line.found).arg(*line.ours);
    case FoundKind::kRevision:
      return tr("Revision %1 instead of %2")
          .arg(hexText(found->device.identity.revision_no, 8), hexText(ours->device.identity.revision_no, 8));
    case FoundKind::kOtherDevice:
      if (deviceText(*found) == deviceText(*ours))
        return tr("Vendor %1, product %2 instead of %3, %4")
            .arg(hexText(found->device.identity.vendor_id, 8), hexText(found->device.identity.product_code, 8),
                 hexText(ours->device.identity.vendor_id, 8), hexText(ours->device.identity.product_code, 8));
      return tr("%1 instead of %2").arg(deviceText(*found), deviceText(*ours));
    case FoundKind::kMissing:
      return tr("Not on the bus; ticked: goes out of the project");
    case FoundKind::kExtra:
      return tr("Not in the project; ticked: comes in");
  }
  return {};
}

QString FoundModel::text(const FoundSlave& line, int column) const {
  const auto of = [](const Project& project, const std::optional<std::size_t>& position) {
    if (!position) return QStringLiteral("\u2013");
    const auto& slave = project.slaves[*position];
    return QStringLiteral("%1  %2").arg(*position).arg(QString::fromStdString(slave.name));
  };
  switch (column) {
    case kStatus:
      return kindText(line.kind);
    case kOurs:
      return of(ours_, line.ours);
    case kFound:
      return line.found ? QStringLiteral("%1  %2").arg(*line.found).arg(deviceText(found_.slaves[*line.found]))
                        : QStringLiteral("\u2013");
    case kDifference:
      return difference(line);
    default:
      return {};
  }
}

QVariant FoundModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto row = static_cast<std::size_t>(index.row());
  const auto& line = lines_[row];
  switch (role) {
    case Qt::DisplayRole:
      return text(line, index.column());
    case Qt::ToolTipRole:
      return text(line, index.column());
    case Qt::CheckStateRole:
      if (index.column() != kStatus || line.kind == FoundKind::kMatched) return {};
      return ticked_[row] ? Qt::Checked : Qt::Unchecked;
    case kKindRole:
      return static_cast<int>(line.kind);
    default:
      return {};
  }
}

QVariant FoundModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kStatus:
      return tr("Take over");
    case kOurs:
      return tr("In the project");
    case kFound:
      return tr("On the bus");
    case kDifference:
      return tr("Difference");
    default:
      return {};
  }
}

Qt::ItemFlags FoundModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemNeverHasChildren;
  const bool differs = lines_[static_cast<std::size_t>(index.row())].kind != FoundKind::kMatched;
  if (index.column() == kStatus && differs) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

bool FoundModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::CheckStateRole || !(flags(index) & Qt::ItemIsUserCheckable)) return false;
  ticked_[static_cast<std::size_t>(index.row())] = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
  return true;
}

}  // namespace syncline::ui
