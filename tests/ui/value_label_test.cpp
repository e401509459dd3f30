// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QImage>
#include <QPixmap>
#include <QSet>

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

/// "max +68.809 u…" would be read as another figure.
TEST(ValueLabel, OfFiguresInARowShowsWholeOnes) {
  ValueLabel label(QStringLiteral("B-A +3 ns   min -5 ns   max +68.809 us"));
  label.resize(label.sizeHint());
  EXPECT_EQ(label.shown(), label.text());
  QSet<QString> seen;
  const int least = label.fontMetrics().horizontalAdvance(QStringLiteral("B-A +3 ns \u2026"));
  for (int width = label.width() - 1; width >= least; --width) {
    label.resize(width, label.height());
    if (label.shown() != label.text()) seen.insert(label.shown());
  }
  EXPECT_EQ(seen, (QSet<QString>{QStringLiteral("B-A +3 ns   min -5 ns \u2026"), QStringLiteral("B-A +3 ns \u2026")}));
  EXPECT_EQ(label.hint(), label.text());
}

/// "+69.306 us at 5…" would be read as another moment.
TEST(ValueLabel, HasAShorterFormWhereItDoesNotFit) {
  ValueLabel label;
  label.setText(QStringLiteral("+69.306 us at 5.002 s"), QStringLiteral("+69.306 us"));
  label.resize(label.sizeHint());
  EXPECT_EQ(label.shown(), label.text());
  label.resize(label.width() - 4, label.height());
  EXPECT_EQ(label.shown(), QStringLiteral("+69.306 us"));
  EXPECT_EQ(label.hint(), label.text());
  label.resize(20, label.height());
  EXPECT_TRUE(label.shown().endsWith(QChar(0x2026)));
  label.setText(QStringLiteral("-1.200 us at 5.002 s"));
  label.resize(label.sizeHint().width() - 4, label.height());
  EXPECT_TRUE(label.shown().endsWith(QChar(0x2026))) << "it was the shorter form of another text";
}

TEST(ValueLabel, ShowsAllOfItInLinesBelowEachOther) {
  ValueLabel label(QStringLiteral("70.000 us, the slave has 50.000 us"));
  label.setWordWrap(true);
  const int line = label.fontMetrics().height();
  label.resize(label.fontMetrics().horizontalAdvance(QStringLiteral("the slave has 50.0")), 4 * line);
  EXPECT_EQ(label.shown(), label.text());
  EXPECT_LT(label.minimumSizeHint().width(), label.fontMetrics().horizontalAdvance(label.text()));
  label.resize(label.width(), line);
  EXPECT_TRUE(label.shown().endsWith(QChar(0x2026))) << "no room for a second line";
  label.setText(QStringLiteral("a_name_without_a_place_where_its_line_could_end"));
  label.resize(label.width(), 4 * line);
  EXPECT_TRUE(label.shown().endsWith(QChar(0x2026)));
}

}  // namespace
}  // namespace syncline::ui
