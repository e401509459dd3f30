// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionTab>
#include <QTabBar>
#include <algorithm>
#include <cmath>
#include <vector>

namespace syncline::ui::theme {
namespace {

double luminance(const QColor& color) {
  const auto channel = [](double value) {
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(color.redF()) + 0.7152 * channel(color.greenF()) + 0.0722 * channel(color.blueF());
}

/// WCAG 2 contrast ratio.
double contrast(const QColor& a, const QColor& b) {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

QColor over(const QColor& fill, const QColor& base) {
  const double alpha = fill.alphaF();
  return QColor::fromRgbF(static_cast<float>(fill.redF() * alpha + base.redF() * (1 - alpha)),
                          static_cast<float>(fill.greenF() * alpha + base.greenF() * (1 - alpha)),
                          static_cast<float>(fill.blueF() * alpha + base.blueF() * (1 - alpha)));
}

/// The pixel that covers most.
QColor strongest(const QImage& image) {
  QColor found(0, 0, 0, 0);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const auto pixel = image.pixelColor(x, y);
      if (pixel.alpha() > found.alpha()) found = pixel;
    }
  }
  return found;
}

class Themes : public ::testing::TestWithParam<Mode> {
 protected:
  Themes() { apply(GetParam()); }
  ~Themes() override { apply(Mode::kLight); }
};

TEST_P(Themes, TextAndTonesCanBeRead) {
  const auto palette = QApplication::palette();
  EXPECT_EQ(isDark(palette), GetParam() != Mode::kLight);
  const bool high = GetParam() == Mode::kContrast;
  const double quiet = high ? 7.0 : 4.5, selected = high ? 7.0 : 4.3;
  for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::Button}) {
    EXPECT_GE(contrast(palette.color(QPalette::Text), palette.color(ground)), 7.0);
    EXPECT_GE(contrast(mutedText(palette), palette.color(ground)), quiet);
  }
  EXPECT_GE(contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)), selected);
  for (const auto tone : {Tone::kNeutral, Tone::kGood, Tone::kBusy, Tone::kWarning, Tone::kBad, Tone::kAccent}) {
    for (const auto ground : {QPalette::Window, QPalette::Base}) {
      const auto fill = over(toneFill(palette, tone), palette.color(ground));
      EXPECT_GE(contrast(toneColor(palette, tone), fill), quiet) << static_cast<int>(tone);
      EXPECT_GE(contrast(palette.color(QPalette::Link), fill), quiet) << "a link, " << static_cast<int>(tone);
    }
  }
}

/// By more than the shade of its ground: whole lines of pixels stand out from a tab that is not chosen.
TEST_P(Themes, TheChosenTabCanBeTold) {
  for (const auto shape : {QTabBar::RoundedNorth, QTabBar::RoundedSouth, QTabBar::RoundedWest, QTabBar::RoundedEast}) {
    const auto picture = [shape](QStyle::State state) {
      QStyleOptionTab tab;
      tab.rect = QRect(0, 0, 80, 80);
      tab.shape = shape;
      tab.position = QStyleOptionTab::Middle;
      tab.palette = QApplication::palette();
      tab.state = QStyle::State_Enabled | state;
      QImage image(tab.rect.size(), QImage::Format_RGB32);
      image.fill(tab.palette.color(QPalette::Window));
      QPainter painter(&image);
      QApplication::style()->drawControl(QStyle::CE_TabBarTabShape, &tab, &painter);
      return image;
    };
    const auto other = picture(QStyle::State_None), chosen = picture(QStyle::State_Selected);
    std::vector<int> rows(static_cast<std::size_t>(chosen.height())), columns(static_cast<std::size_t>(chosen.width()));
    for (int y = 0; y < chosen.height(); ++y) {
      for (int x = 0; x < chosen.width(); ++x) {
        if (contrast(chosen.pixelColor(x, y), other.pixelColor(x, y)) < 3.0) continue;
        ++rows[static_cast<std::size_t>(y)];
        ++columns[static_cast<std::size_t>(x)];
      }
    }
    const auto lines = std::ranges::count_if(rows, [&](int n) { return 10 * n >= 9 * chosen.width(); }) +
                       std::ranges::count_if(columns, [&](int n) { return 10 * n >= 9 * chosen.height(); });
    EXPECT_GE(lines, 2) << static_cast<int>(shape);
  }
}

TEST_P(Themes, EveryIconCanBeDrawn) {
  const auto names = QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")});
  ASSERT_GE(names.size(), 15);
  for (const auto& file : names) {
    const auto drawn = icon(file.section(u'.', 0, 0), QApplication::palette());
    ASSERT_FALSE(drawn.isNull()) << qPrintable(file);
    const auto shown = drawn.pixmap(QSize(16, 16), 1).toImage();
    EXPECT_GE(strongest(shown).alpha(), 128) << qPrintable(file) << " shows nothing";
  }
  EXPECT_TRUE(icon(QStringLiteral("none of this name"), QApplication::palette()).isNull());
}

TEST_P(Themes, IconsAreDrawnInThePixelsOfTheirScreenAndInTheColourOfTheirMode) {
  const auto palette = QApplication::palette();
  const auto drawn = icon(QStringLiteral("save"), palette);
  for (const double scale : {1.0, 1.25, 1.5, 2.0, 4.0}) {
    EXPECT_EQ(drawn.pixmap(QSize(24, 24), scale).size(), QSize(24, 24) * scale);
  }
  const auto color = [&](QIcon::Mode mode) { return strongest(drawn.pixmap(QSize(48, 48), 1, mode).toImage()); };
  EXPECT_EQ(color(QIcon::Normal), palette.color(QPalette::Active, QPalette::ButtonText));
  EXPECT_EQ(color(QIcon::Disabled), palette.color(QPalette::Disabled, QPalette::ButtonText));
  EXPECT_EQ(color(QIcon::Selected), palette.color(QPalette::HighlightedText));
}

INSTANTIATE_TEST_SUITE_P(All, Themes, ::testing::Values(Mode::kLight, Mode::kDark, Mode::kContrast));

}  // namespace
}  // namespace syncline::ui::theme
