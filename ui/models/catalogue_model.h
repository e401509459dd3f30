// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <optional>
#include <vector>

#include "eni/catalogue/catalogue_entry.h"

namespace syncline::ui {

/// Devices of the catalogue: vendor, group, device, and below the device its older revisions.
class CatalogueModel final : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { kDevice, kRevision, kColumns };
  enum Role { kEntryRole = Qt::UserRole + 1 };  // number of the entry, -1 for vendors and groups

  explicit CatalogueModel(QObject* parent = nullptr);
  void setEntries(std::vector<eni::CatalogueEntry> entries);
  [[nodiscard]] const eni::CatalogueEntry* entry(int number) const;
  [[nodiscard]] const eni::CatalogueEntry* entry(const QModelIndex& index) const;
  /// The device that was dragged last, whatever is listed since; nullptr when it has another number in the catalogue.
  [[nodiscard]] const eni::CatalogueEntry* dragged(qint64 id) const;
  /// The first device, or nothing.
  [[nodiscard]] QModelIndex firstDevice() const;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] Qt::DropActions supportedDragActions() const override { return Qt::CopyAction; }
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;

 private:
  struct Node {
    QString text;
    int entry = -1;
    Node* parent = nullptr;
    int row = 0;
    std::vector<std::unique_ptr<Node>> below;
  };
  static Node* child(Node& parent, const QString& text, int entry);
  static Node* childNamed(Node& parent, const QString& text);
  [[nodiscard]] const Node& nodeOf(const QModelIndex& index) const;
  [[nodiscard]] QString toolTip(const eni::CatalogueEntry& entry) const;

  std::vector<eni::CatalogueEntry> entries_;
  mutable std::optional<eni::CatalogueEntry> dragged_;
  Node root_;
};

}  // namespace syncline::ui
