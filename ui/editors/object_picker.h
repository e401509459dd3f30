// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>
#include <cstdint>
#include <vector>

class QSortFilterProxyModel;
class QTableView;

namespace syncline {
struct DeviceDescription;
}  // namespace syncline

namespace syncline::ui {

enum class ObjectUse : std::uint8_t { kWrite, kMapOutputs, kMapInputs };

struct PickableObject {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  QString name, type;
  std::uint16_t bits = 0;
  std::vector<std::uint8_t> default_data;
};
/// Objects of a device's dictionary that can be written, or mapped into PDOs.
[[nodiscard]] std::vector<PickableObject> pickableObjects(const DeviceDescription& device, ObjectUse use);

/// An object out of a device's dictionary, found by any words of its index, name and type.
class ObjectPicker final : public QDialog {
  Q_OBJECT

 public:
  ObjectPicker(std::vector<PickableObject> objects, QWidget* parent);

 Q_SIGNALS:
  void picked(const syncline::ui::PickableObject& object);

 private:
  void pick();

  std::vector<PickableObject> objects_;
  QSortFilterProxyModel* shown_;
  QTableView* table_;
};

}  // namespace syncline::ui
