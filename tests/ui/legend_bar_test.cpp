// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/legend_bar.h"

#include <gtest/gtest.h>

#include <QImage>

namespace syncline::ui {
namespace {

constexpr QRgb kSecond = qRgb(0, 128, 255);

LegendBar::Entry entry(const char* name, const QString& value, QRgb color) {
  return {.name = QLatin1String(name), .short_name = {}, .value = value, .color = QColor::fromRgb(color)};
}

/// Where the swatch of the second entry begins; -1: it is not there.
int placeOfSecond(LegendBar& bar) {
  const auto image = bar.grab().toImage();
  for (int x = 0; x < image.width(); ++x) {
    for (int y = 0; y < image.height(); ++y) {
      if (image.pixel(x, y) == kSecond) return x;
    }
  }
  return -1;
}

TEST(LegendBar, DigitsMoveNoNeighbour) {
  LegendBar bar;
  bar.resize(600, 20);
  const auto show = [&bar](const char* first, const QString& value) {
    bar.setEntries({entry(first, value, qRgb(255, 0, 0)), entry("second", QStringLiteral("1 ns"), kSecond)});
    return placeOfSecond(bar);
  };
  const int narrow = show("first", QStringLiteral("+2 ns"));
  ASSERT_GT(narrow, 0);
  const int wide = show("first", QStringLiteral("+2000 ns"));
  EXPECT_GT(wide, narrow);
  EXPECT_EQ(show("first", QStringLiteral("+2 ns")), wide) << "as wide as it was once";
  for (int update = 0; update < 60; ++update) show("first", QStringLiteral("+%1 ns").arg(update % 10));
  EXPECT_EQ(show("first", QStringLiteral("+2 ns")), narrow) << "in the long run no room is wasted";
  EXPECT_LT(show("other", QStringLiteral("+2 ns")), wide) << "another signal begins anew";
}

}  // namespace
}  // namespace syncline::ui
