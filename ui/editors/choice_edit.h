// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>

namespace syncline::ui {

/// A choice. Tells by activated() alone, which showing does not emit.
class ChoiceEdit : public QComboBox {
  Q_OBJECT

 public:
  explicit ChoiceEdit(QWidget* parent = nullptr);
};

}  // namespace syncline::ui
