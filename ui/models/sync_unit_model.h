// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "ui/models/grouped_model.h"

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::ui {

/// What of a slave is in a Sync Unit: a slave's outputs may be in one and its inputs in another.
struct UnitMember {
  int slave = -1;   // position
  int address = 0;  // station address
  bool outputs = false, inputs = false;
  bool operator==(const UnitMember&) const = default;
};

/// The slaves of each Sync Unit: above the units, the unnamed one of the base task first, and below each what is in it.
/// Slaves without process data are in none. Dragged onto a unit, they are wanted there; nothing changes here before the
/// edited project comes back.
class SyncUnitModel final : public GroupedModel {
  Q_OBJECT

 public:
  enum Column { kSlave, kData, kColumns };

  explicit SyncUnitModel(QObject* parent = nullptr);
  void setProject(const Project& project);
  /// Of a row below a unit; null for a unit.
  [[nodiscard]] const UnitMember* member(const QModelIndex& index) const;
  /// "" = the unnamed one; of a unit's own row, or of one below it.
  [[nodiscard]] QString unit(const QModelIndex& index) const;
  /// Rows of a slave: one, or two where its outputs are elsewhere than its inputs.
  [[nodiscard]] QModelIndexList find(int address) const;

  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
  [[nodiscard]] bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                     const QModelIndex& parent) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

 Q_SIGNALS:
  void moveWanted(const std::vector<syncline::ui::UnitMember>& members, const QString& unit);

 protected:
  [[nodiscard]] int groups() const override { return static_cast<int>(units_.size()); }
  [[nodiscard]] int members(std::size_t group) const override { return static_cast<int>(units_[group].members.size()); }

 private:
  struct Unit {
    QString name;
    std::vector<UnitMember> members;
    bool operator==(const Unit&) const = default;
  };
  [[nodiscard]] std::vector<UnitMember> dragged(const QMimeData& data) const;

  std::vector<Unit> units_;
  std::vector<QString> names_;  // of the slaves
};

}  // namespace syncline::ui
