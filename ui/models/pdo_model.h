// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "config/pdo_description.h"

namespace syncline {
struct SlaveSettings;
}  // namespace syncline

namespace syncline::ui {

/// PDOs of one direction with their assignment as check boxes. Ticking one that assigned ones exclude takes their
/// place, in one edit; a mandatory one cannot be unticked, nor what it excludes be ticked, and the tool tip says why.
class PdoModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kIndex, kName, kSyncManager, kSize, kColumns };

  explicit PdoModel(PdoDirection direction, QObject* parent = nullptr);

  void setSlave(const SlaveSettings& slave);
  void clear();
  [[nodiscard]] const Pdo* pdo(int row) const;
  [[nodiscard]] std::uint32_t assignedBits() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Does not change the model: asks for the edit, and the edited project comes back by setSlave().
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void assignmentWanted(std::vector<std::uint16_t> pdos);

 private:
  struct Row {
    Pdo pdo;
    bool assigned = false;
    QString locked;                         // why it cannot be changed; empty = free
    std::vector<std::uint16_t> replaced{};  // assigned ones whose place it would take
  };

  void findRules(Row& row) const;
  [[nodiscard]] QString hint(const Row& row) const;
  [[nodiscard]] QVariant text(const Row& row, int column) const;

  PdoDirection direction_;
  std::vector<Row> rows_;
  std::vector<std::uint16_t> chosen_;  // in the project's order
};

/// Entries of one PDO: bit offset, object, name, type, length. Where the mapping may change they are dragged to another
/// place among themselves; who owns them moves them.
class PdoEntryModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kOffset, kObject, kName, kType, kLength, kColumns };

  explicit PdoEntryModel(QObject* parent = nullptr);
  void setEntries(std::vector<PdoEntry> entries);
  void setMovable(bool movable) { movable_ = movable; }

  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
  /// Moves nothing itself.
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 Q_SIGNALS:
  /// The entry shall stand at `to` of the list as it is without it.
  void moveWanted(int from, int to);

 private:
  bool movable_ = false;
  std::vector<PdoEntry> entries_;
  std::vector<std::uint32_t> offsets_;
};

}  // namespace syncline::ui
