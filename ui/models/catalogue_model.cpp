// SPDX-License-Identifier: Apache-2.0
#include "ui/models/catalogue_model.h"

#include <QMimeData>
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "ui/models/dragged.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString orElse(const std::string& text, const QString& other) {
  const auto trimmed = QString::fromStdString(text).trimmed();
  return trimmed.isEmpty() ? other : trimmed;
}

}  // namespace

CatalogueModel::CatalogueModel(QObject* parent) : QAbstractItemModel(parent) {}

CatalogueModel::Node* CatalogueModel::child(Node& parent, const QString& text, int entry) {
  auto node = std::make_unique<Node>();
  node->text = text;
  node->entry = entry;
  node->parent = &parent;
  node->row = static_cast<int>(parent.below.size());
  parent.below.push_back(std::move(node));
  return parent.below.back().get();
}

CatalogueModel::Node* CatalogueModel::childNamed(Node& parent, const QString& text) {
  const auto found = std::ranges::find_if(parent.below, [&](const auto& node) { return node->text == text; });
  return found != parent.below.end() ? found->get() : child(parent, text, -1);
}

void CatalogueModel::setEntries(std::vector<eni::CatalogueEntry> entries) {
  beginResetModel();
  entries_ = std::move(entries);
  root_.below.clear();
  // Revisions of a type come one behind the other, the newest first.
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::string>, Node*> newest;
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const auto& one = entries_[static_cast<std::size_t>(i)];
    auto& known = newest[{one.identity.vendor_id, one.identity.product_code, one.type}];
    if (known != nullptr) {
      child(*known, known->text, i);
      continue;
    }
    auto* vendor = childNamed(root_, orElse(one.vendor_name, hexText(one.identity.vendor_id, 8)));
    auto* group = childNamed(*vendor, orElse(one.group_name, orElse(one.group_type, tr("Other devices"))));
    const auto type = orElse(one.type, tr("Device")), name = orElse(one.name, {});
    // Many vendors repeat the type at the beginning of the name.
    const bool repeats = name.startsWith(type);
    known = child(*group, name.isEmpty() || repeats ? (repeats ? name : type) : type + QStringLiteral("  ") + name, i);
  }
  endResetModel();
}

const eni::CatalogueEntry* CatalogueModel::entry(int number) const {
  return number >= 0 && number < static_cast<int>(entries_.size()) ? &entries_[static_cast<std::size_t>(number)]
                                                                   : nullptr;
}

const eni::CatalogueEntry* CatalogueModel::entry(const QModelIndex& index) const {
  return index.isValid() ? entry(nodeOf(index).entry) : nullptr;
}

QModelIndex CatalogueModel::firstDevice() const {
  const auto device = index(0, 0, index(0, 0, index(0, 0)));
  return device;
}

const CatalogueModel::Node& CatalogueModel::nodeOf(const QModelIndex& index) const {
  return index.isValid() ? *static_cast<const Node*>(index.constInternalPointer()) : root_;
}

QModelIndex CatalogueModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, nodeOf(parent).below[static_cast<std::size_t>(row)].get());
}

QModelIndex CatalogueModel::parent(const QModelIndex& child) const {
  if (!child.isValid()) return {};
  auto* parent = nodeOf(child).parent;
  return parent == nullptr || parent == &root_ ? QModelIndex() : createIndex(parent->row, 0, parent);
}

int CatalogueModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(nodeOf(parent).below.size());
}

int CatalogueModel::columnCount(const QModelIndex&) const { return kColumns; }

QVariant CatalogueModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& node = nodeOf(index);
  const auto* device = entry(node.entry);
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == kDevice) return node.text;
      return device == nullptr ? QVariant() : hexText(device->identity.revision_no, 8);
    case Qt::ToolTipRole:
      return device == nullptr ? node.text : toolTip(*device);
    case Qt::AccessibleTextRole:
      if (device == nullptr || index.column() != kDevice) return data(index, Qt::DisplayRole);
      return tr("%1, revision %2").arg(node.text, hexText(device->identity.revision_no, 8));
    case kEntryRole:
      return node.entry;
    default:
      return {};
  }
}

QString CatalogueModel::toolTip(const eni::CatalogueEntry& device) const {
  return tr("%1\nProduct code %2, revision %3\n%4")
      .arg(orElse(device.name, orElse(device.type, {})), hexText(device.identity.product_code, 8),
           hexText(device.identity.revision_no, 8), QString::fromStdString(device.file));
}

QVariant CatalogueModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == kDevice ? tr("Device") : tr("Revision");
}

Qt::ItemFlags CatalogueModel::flags(const QModelIndex& index) const {
  const auto flags = QAbstractItemModel::flags(index);
  return entry(index) == nullptr ? flags : flags | Qt::ItemIsDragEnabled;
}

const eni::CatalogueEntry* CatalogueModel::dragged(qint64 id) const {
  return dragged_ && dragged_->id == id ? &*dragged_ : nullptr;
}

QStringList CatalogueModel::mimeTypes() const { return {kDeviceMime}; }

QMimeData* CatalogueModel::mimeData(const QModelIndexList& indexes) const {
  if (indexes.isEmpty() || entry(indexes.front()) == nullptr) return nullptr;
  dragged_ = *entry(indexes.front());
  return draggedDevice({dragged_->id, dragged_->physics});
}

}  // namespace syncline::ui
