// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>

#include "support/types.h"

namespace syncline::ui {

/// A time in microseconds with the nanoseconds as decimals; tells of a change when editing ends.
class TimeEdit final : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit TimeEdit(QWidget* parent = nullptr);
  void setRangeNs(Nanoseconds minimum, Nanoseconds maximum);
  [[nodiscard]] Nanoseconds valueNs() const;
  /// Shows a value without telling of a change.
  void showNs(Nanoseconds value);

 Q_SIGNALS:
  void editedNs(syncline::Nanoseconds value);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace syncline::ui
