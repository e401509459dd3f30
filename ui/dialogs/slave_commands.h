// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "config/device_description.h"
#include "config/project.h"
#include "config/slave_edits.h"

class QWidget;

namespace syncline::eni {
struct CatalogueEntry;
}  // namespace syncline::eni

namespace syncline::ui {

struct DropPlace;
struct SlaveMark;

class DeviceCatalogue;
class Workspace;

/// What is done to the slaves of the project: add, duplicate, move, remove, rewire, replace; each one undo step.
/// Nothing while Workspace::whySlavesStay() says why. What takes time means the slave that it was asked for, wherever
/// that is when it is done.
class SlaveCommands final : public QObject {
  Q_OBJECT

 public:
  /// `commit`: takes what the fields hold; false where that cannot be.
  SlaveCommands(Workspace& workspace, DeviceCatalogue& catalogue, QWidget& window, std::function<bool()> commit);

  QAction *add, *duplicate, *move_up, *move_down, *remove, *replace;
  [[nodiscard]] QList<QAction*> all() const { return {add, duplicate, move_up, move_down, replace, remove}; }

  /// The selected node, which the actions are about; -1 = the master.
  void setNode(int slave);
  /// Behind the selected slave.
  void addDevice(const eni::CatalogueEntry& device);
  void addDeviceTo(const eni::CatalogueEntry& device, DropPlace place);
  void addDeviceAt(const eni::CatalogueEntry& device, PreviousPort at);
  void move(int slave, DropPlace place);
  void rewire(int slave, PreviousPort at);

 Q_SIGNALS:
  /// Where the slave is now that was meant.
  void nodeWanted(int slave);
  /// Somebody wants to choose a device.
  void catalogueWanted();
  /// Why something was not done, or what it took along; a sentence.
  void told(const QString& text);

 private:
  using Edit = std::function<EditedSlave(Project&)>;
  QAction* make(const char* name, const QString& text, const QString& tip, const QKeySequence& keys);
  void connectActions();
  [[nodiscard]] bool mayEdit();
  bool apply(const QString& text, const Edit& edit);
  /// `edit`: with the slave that is meant, where it stands then; -1 = the master.
  using Addition = std::function<EditedSlave(Project&, const DeviceDescription&, int)>;
  void fetch(const eni::CatalogueEntry& device, int slave, Addition edit);
  void removeSelected();
  void replaceSelected();
  void replaceBy(const SlaveMark& mark, const DeviceDescription& device);
  void updateActions();
  [[nodiscard]] QString nameOf(int slave) const;

  Workspace& workspace_;
  DeviceCatalogue& catalogue_;
  QWidget& window_;
  std::function<bool()> commit_;
  int slave_ = -1;
};

/// Why the slave cannot stand there, a sentence.
[[nodiscard]] QString obstacleText(WiringObstacle obstacle);

}  // namespace syncline::ui
