// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractItemModel>
#include <QStringList>
#include <vector>

#include "config/network_config.h"
#include "ui/models/dragged.h"
#include "ui/models/drop_place.h"
#include "ui/models/node_tree.h"

namespace syncline {
struct Project;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// The project explorer's tree: the master of each network of the machine, below it the slaves, with their live states.
/// One network is in work: its slaves are meant wherever a position alone is said, can be moved, and its master stands
/// out; of the others one only sees them. Slaves are meant by their position, -1 is the master.
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
    kNetworkRole,                   // which network of the machine
    kOtherRole,                     // that is not in work
  };
  using LinkState = NodeTree::Link;
  using Shape = NodeTree::Shape;

  explicit NetworkModel(QObject* parent = nullptr);

  void setShape(Shape shape);
  [[nodiscard]] Shape shape() const { return shape_; }
  /// What is edited, of the network in work.
  void setProject(const Project& project);
  /// All networks of the machine with their names, and which of them is in work. `projects` are read, not kept.
  void setNetworks(const QStringList& names, const std::vector<const Project*>& projects, int in_work);
  [[nodiscard]] int networkCount() const { return static_cast<int>(trees_.size()); }
  [[nodiscard]] int network() const { return static_cast<int>(in_work_); }
  /// Marks who uses distributed clocks and who leads, as compiled; nullptr when nothing could be compiled.
  void setConfiguration(const NetworkConfig* config) { setConfiguration(network(), config); }
  /// Live states; one dataChanged over the rows of a parent that differ.
  /// `positions`: of each slave in the snapshot; -1: it is not in it.
  void setSnapshot(const Snapshot& snapshot, const std::vector<int>& positions);
  /// The same of any network.
  void setConfiguration(int network, const NetworkConfig* config);
  void setSnapshot(int network, const Snapshot& snapshot, const std::vector<int>& positions);
  [[nodiscard]] QModelIndex indexOf(int slave) const { return indexOf(network(), slave); }
  [[nodiscard]] QModelIndex indexOf(int network, int slave) const;
  [[nodiscard]] int slaveCount() const { return tree().size(); }
  /// The slave with a station address, -1 = none.
  [[nodiscard]] int slaveAt(int address) const { return tree().slave_at(address); }
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
  using Node = NodeTree::Node;

  [[nodiscard]] const NodeTree& tree() const { return trees_[in_work_]; }
  [[nodiscard]] QVariant nodeData(const Node& node, int slave, int role) const;
  [[nodiscard]] static QString stateText(const Node& node, int slave);
  [[nodiscard]] QString toolTip(const Node& node, int slave) const;
  [[nodiscard]] QString spokenText(const Node& node, int slave) const;
  [[nodiscard]] QStringList marksOf(const Node& node) const;
  [[nodiscard]] DropPlace placeOf(int row, const QModelIndex& parent) const;
  [[nodiscard]] QVariant masterData(int network, int role) const;
  void tellOf(int network, const std::vector<int>& changed);

  std::vector<NodeTree> trees_{1};  // of each network
  QStringList names_;               // theirs
  std::size_t in_work_ = 0;
  Shape shape_ = Shape::kClassic;
  bool fixed_ = false;
};

}  // namespace syncline::ui
