// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/choice_edit.h"

#include <QWheelEvent>

namespace syncline::ui {

ChoiceEdit::ChoiceEdit(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
}

void ChoiceEdit::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QComboBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

}  // namespace syncline::ui
