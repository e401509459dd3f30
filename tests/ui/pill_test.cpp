// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/pill.h"

#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

using theme::Tone;

constexpr int kMarkEnds = 17;  // left of it there is the mark alone

/// Where the mark of a pill without words is painted: what is nearer to its own colour than to the ground.
std::vector<bool> markOf(Tone tone) {
  Pill pill;
  pill.setState(tone, QString());
  pill.resize(60, 24);
  QImage image(pill.size(), QImage::Format_RGB32);
  const auto ground = QColor(Qt::white);
  image.fill(ground);
  pill.render(&image);
  const auto color = theme::toneColor(pill.palette(), tone);
  std::vector<bool> painted;
  for (int y = 4; y < 20; ++y) {
    for (int x = 6; x < kMarkEnds; ++x) {
      const auto pixel = image.pixelColor(x, y);
      const auto apart = [&](const QColor& other) {
        return std::abs(pixel.red() - other.red()) + std::abs(pixel.green() - other.green()) +
               std::abs(pixel.blue() - other.blue());
      };
      painted.push_back(apart(color) < apart(ground));
    }
  }
  return painted;
}

/// Whoever sees no colours sees what a pill says before its words.
TEST(PillTest, MarksHaveAFormEach) {
  theme::apply(theme::Mode::kLight);
  constexpr std::array kTones{Tone::kNeutral, Tone::kGood, Tone::kBusy, Tone::kWarning, Tone::kBad};
  for (std::size_t i = 0; i < kTones.size(); ++i) {
    const auto one = markOf(kTones[i]);
    EXPECT_GE(std::ranges::count(one, true), 12) << i;
    for (std::size_t k = 0; k < i; ++k) {
      const auto other = markOf(kTones[k]);
      int different = 0;
      for (std::size_t pixel = 0; pixel < one.size(); ++pixel) different += one[pixel] != other[pixel] ? 1 : 0;
      EXPECT_GE(different, 9) << "tones " << k << " and " << i;
    }
  }
}

}  // namespace
}  // namespace syncline::ui
