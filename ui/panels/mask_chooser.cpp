// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/mask_chooser.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>

#include "ui/widgets/named.h"

namespace syncline::ui {

MaskChooser::MaskChooser(QWidget* parent)
    : QWidget(parent),
      kind_(named(new QComboBox, "stabilityMask", tr("Mask"))),
      own_(named(new QLineEdit, "stabilityOwnMask", tr("Own mask"))) {
  kind_->addItems({tr("Limit"), tr("1/25 of the cycle"), tr("Own mask")});
  const QStringList tips{tr("The most that the figure can be while every value is within the limit of the signal: the "
                            "sync window, or that "
                            "of the DCM error"),
                         tr("The most that the figure can be while every value is within a twenty-fifth of the cycle"),
                         tr("What you type: observation time and value, points parted by semicolons")};
  for (int i = 0; i < kind_->count(); ++i) kind_->setItemData(i, tips[i], Qt::ToolTipRole);
  own_->setPlaceholderText(QStringLiteral("1ms 100ns; 1s 250ns"));
  own_->setToolTip(
      tr("Observation time and value: \"1ms 100ns; 1s 250ns\". Between points the mask is straight on both logarithmic "
         "axes, outside of them nothing is asked. A value alone is asked at every time."));
  own_->setVisible(false);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(kind_);
  layout->addWidget(own_, 1);
  connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
    own_->setVisible(kind() == Kind::kOwn);
    Q_EMIT changed();
  });
  connect(own_, &QLineEdit::editingFinished, this, &MaskChooser::changed);
}

void MaskChooser::setKind(Kind kind) { kind_->setCurrentIndex(static_cast<int>(kind)); }
MaskChooser::Kind MaskChooser::kind() const { return static_cast<Kind>(kind_->currentIndex()); }

void MaskChooser::setOwn(const QString& text) {
  own_->setText(text);
  Q_EMIT changed();
}

StabilityMask MaskChooser::own(StabilityFigure figure) const {
  const auto mask = parse_mask(own_->text().toStdString(), figure);
  return mask ? *mask : StabilityMask{};
}

QString MaskChooser::problem(StabilityFigure figure) const {
  const auto mask = parse_mask(own_->text().toStdString(), figure);
  if (mask) return {};
  return tr("Nobody understands \"%1\" in the mask.").arg(QString::fromStdString(mask.error().subject));
}

}  // namespace syncline::ui
