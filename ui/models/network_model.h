// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractItemModel>
#include <vector>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "config/project.h"

namespace syncline::ui {

/// The project explorer's tree: the master, below it the slaves in bus order, with their live states.
class NetworkModel final : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Role {
    kStateRole = Qt::UserRole + 1,  // AlState as int, -1 when offline
    kErrorRole,                     // error flag of the AL status
    kMarksRole,                     // QStringList: "REF", "DC"
    kSlaveRole,                     // position, -1 = master
  };

  explicit NetworkModel(QObject* parent = nullptr);

  void setProject(const Project& project);
  /// Marks who uses distributed clocks and who leads, as compiled; nullptr when nothing could be compiled.
  void setConfiguration(const NetworkConfig* config);
  /// Live states; one dataChanged over the rows that differ.
  void setSnapshot(const Snapshot& snapshot);
  [[nodiscard]] QModelIndex indexOf(int slave) const;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Node {
    QString name, device;
    bool dc = false, configured_reference = false, live_reference = false;
    int al_status = -1;  // -1 offline
    std::uint16_t station_address = 0;
    bool operator==(const Node&) const = default;
  };

  [[nodiscard]] QVariant nodeData(const Node& node, int slave, int role) const;
  [[nodiscard]] static QString stateText(const Node& node, int slave);
  [[nodiscard]] QString toolTip(const Node& node, int slave) const;
  void assign(std::vector<Node> slaves);

  Node master_;
  std::vector<Node> slaves_;
};

}  // namespace syncline::ui
