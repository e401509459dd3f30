// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QImage>
#include <QPixmap>

#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

TEST(ValueLabel, SaysInItsToolTipWhatDoesNotFit) {
  ValueLabel label(QStringLiteral("Slave_1001 [a name that is longer than any card is wide]"));
  label.setToolTip(QStringLiteral("whose clock it is"));
  label.resize(label.sizeHint());
  EXPECT_EQ(label.shown(), label.text());
  EXPECT_EQ(label.hint(), label.toolTip());
  const auto whole = label.grab().toImage();
  label.resize(80, label.height());
  EXPECT_TRUE(label.shown().endsWith(QChar(0x2026)));
  EXPECT_EQ(label.hint(), label.text() + QStringLiteral("\nwhose clock it is"));
  EXPECT_NE(label.grab().toImage(), whole.copy(0, 0, 80, whole.height())) << "an ellipsis, not a cut";
  EXPECT_LT(label.minimumSizeHint().width(), label.sizeHint().width());
  label.setText(QStringLiteral("0x00005C17 Syncline Simulated Devices"));
  EXPECT_EQ(label.minimumSizeHint().width(), label.sizeHint().width()) << "ordinary values are not cut";
}

}  // namespace
}  // namespace syncline::ui
