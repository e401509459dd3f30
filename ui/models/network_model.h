// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractItemModel>
#include <vector>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "config/project.h"
#include "ui/models/dragged.h"
#include "ui/models/drop_place.h"

namespace syncline::ui {

/// The project explorer's tree: the master, below it the slaves, with their live states. Slaves stand in bus order
/// below the master (flat), or below the slave from which their line branches off (classic).
class NetworkModel final : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Role {
    kStateRole = Qt::UserRole + 1,  // AlState as int, -1 when offline
    kErrorRole,                     // error flag of the AL status
    kMarksRole,                     // QStringList: "REF", "DC"
    kSlaveRole,                     // position, -1 = master
    kAddressRole,                   // station address, 0 = master
    kLinkRole,                      // LinkState as int
    kTopologyMarksRole,             // QStringList: the marks, who hot-connects, who has no clock
  };
  enum class LinkState { kOffline, kGood, kBroken, kSilent };  // cable to the slave; kSilent: it does not answer
  enum class Shape { kClassic, kFlat };

  explicit NetworkModel(QObject* parent = nullptr);

  void setShape(Shape shape);
  [[nodiscard]] Shape shape() const { return shape_; }
  void setProject(const Project& project);
  /// Marks who uses distributed clocks and who leads, as compiled; nullptr when nothing could be compiled.
  void setConfiguration(const NetworkConfig* config);
  /// Live states; one dataChanged over the rows of a parent that differ.
  /// `positions`: of each slave in the snapshot; -1: it is not in it.
  void setSnapshot(const Snapshot& snapshot, const std::vector<int>& positions);
  [[nodiscard]] QModelIndex indexOf(int slave) const;
  [[nodiscard]] int slaveCount() const { return static_cast<int>(slaves_.size()); }
  /// The slave with a station address, -1 = none.
  [[nodiscard]] int slaveAt(int address) const;
  /// Slaves stay where they are, and none are added.
  void setFixed(bool fixed) { fixed_ = fixed; }

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] Qt::DropActions supportedDragActions() const override { return Qt::MoveAction; }
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction | Qt::CopyAction; }
  [[nodiscard]] QStringList mimeTypes() const override { return {kSlaveMime, kDeviceMime}; }
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
  /// Not what another window drags, nor a slave that is gone.
  [[nodiscard]] bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                     const QModelIndex& parent) const override;
  /// Changes nothing itself: says what is wanted. Between two rows: there and nowhere else.
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

 Q_SIGNALS:
  void slaveDropped(int slave, syncline::ui::DropPlace place);
  /// `device`: its number in the catalogue.
  void deviceDropped(qint64 device, syncline::ui::DropPlace place);

 private:
  struct Node {
    QString name, device, group;
    bool dc = false, configured_reference = false, live_reference = false, optional = false;
    int al_status = -1;  // -1 offline
    LinkState link = LinkState::kOffline;
    std::uint16_t station_address = 0;
    bool operator==(const Node&) const = default;
  };

  [[nodiscard]] QVariant nodeData(const Node& node, int slave, int role) const;
  [[nodiscard]] static QString stateText(const Node& node, int slave);
  [[nodiscard]] QString toolTip(const Node& node, int slave) const;
  [[nodiscard]] QString spokenText(const Node& node, int slave) const;
  [[nodiscard]] QStringList marksOf(const Node& node) const;
  [[nodiscard]] DropPlace placeOf(int row, const QModelIndex& parent) const;
  void assign(std::vector<Node> slaves, std::vector<int> classic);
  void arrange();
  void tellOf(const std::vector<int>& changed);

  Node master_;
  std::vector<Node> slaves_;
  std::vector<int> classic_;  // whom each slave stands below in the classic tree; -1 = the master
  Shape shape_ = Shape::kClassic;
  std::vector<int> parents_, rows_;      // as shown
  std::vector<std::vector<int>> below_;  // of the master, of slave 0, 1, ...
  bool fixed_ = false;
};

}  // namespace syncline::ui
