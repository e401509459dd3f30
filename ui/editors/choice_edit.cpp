// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/choice_edit.h"

namespace syncline::ui {

ChoiceEdit::ChoiceEdit(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
}

}  // namespace syncline::ui
