// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <string>
#include <vector>

class QMimeData;

/// What is dragged within the window, as what it is and not as where it stands: slaves and devices come, go and move
/// while the mouse is on its way. What another window drags means nothing here.
namespace syncline::ui {

inline const QString kSlaveMime = QStringLiteral("application/x-syncline-slave");
inline const QString kUnitMembersMime = QStringLiteral("application/x-syncline-unit-members");
inline const QString kDeviceMime = QStringLiteral("application/x-syncline-device");

/// A slave by its station address.
[[nodiscard]] QMimeData* draggedSlave(int address);
[[nodiscard]] std::optional<int> addressOf(const QMimeData& data);

/// What of a slave goes into another Sync Unit, by its station address.
struct DraggedMember {
  int address = 0;
  bool outputs = false, inputs = false;
};
[[nodiscard]] QMimeData* draggedMembers(const std::vector<DraggedMember>& members);
[[nodiscard]] std::vector<DraggedMember> membersOf(const QMimeData& data);

/// A device of the catalogue by its number there. Its ports ("YKY", as Physics of the ESI) say where it may hang.
struct DraggedDevice {
  qint64 id = 0;
  std::string physics;
};
[[nodiscard]] QMimeData* draggedDevice(const DraggedDevice& device);
[[nodiscard]] std::optional<DraggedDevice> deviceOf(const QMimeData& data);

}  // namespace syncline::ui
