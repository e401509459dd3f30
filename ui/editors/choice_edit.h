// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>

namespace syncline::ui {

/// A choice that a page that scrolls does not change on its way. Tells by activated() alone, which showing does not
/// emit.
class ChoiceEdit : public QComboBox {
  Q_OBJECT

 public:
  explicit ChoiceEdit(QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace syncline::ui
