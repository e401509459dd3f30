// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/dc_mode_delegate.h"

#include "ui/editors/choice_edit.h"
#include "ui/theme/theme.h"
#include "ui/wizard/dc_mode_model.h"

namespace syncline::ui {

QWidget* DcModeDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
  auto* box = new ChoiceEdit(parent);
  box->setObjectName(index.column() == DcModeModel::kMode ? QStringLiteral("wizardModeEdit")
                                                          : QStringLiteral("wizardFactorEdit"));
  box->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
  for (const auto& choice : index.data(DcModeModel::kChoicesRole).toList()) {
    const auto pair = choice.toList();
    box->addItem(pair.value(0).toString(), pair.value(1));
  }
  // One choice is one edit: it is handed in when it is made.
  auto* self = const_cast<DcModeDelegate*>(this);
  connect(box, &QComboBox::activated, self, [self, box] {
    Q_EMIT self->commitData(box);
    Q_EMIT self->closeEditor(box);
  });
  return box;
}

void DcModeDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* box = static_cast<QComboBox*>(editor);
  box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
}

void DcModeDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  const auto* box = static_cast<QComboBox*>(editor);
  if (box->currentIndex() >= 0 && box->currentData() != index.data(Qt::EditRole))
    model->setData(index, box->currentData(), Qt::EditRole);
}

void DcModeDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const int severity = index.data(DcModeModel::kSeverityRole).toInt();
  if (index.column() == DcModeModel::kNote && severity > 0) {
    const auto tone = severity > 1 ? theme::Tone::kBad : theme::Tone::kWarning;
    option->palette.setColor(QPalette::Text, theme::toneColor(option->palette, tone));
  } else if (!index.flags().testFlag(Qt::ItemIsEditable) && index.column() != DcModeModel::kSlave) {
    option->palette.setColor(QPalette::Text, theme::mutedText(option->palette));
  }
}

}  // namespace syncline::ui
