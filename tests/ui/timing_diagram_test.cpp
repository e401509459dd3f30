// SPDX-License-Identifier: Apache-2.0
// One cycle of a slave to scale, and what it has in its registers beside what was compiled.
#include "ui/plots/timing_diagram.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QLabel>
#include <QPoint>
#include <vector>

#include "support/running_window.h"
#include "ui/plots/plot_colors.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

dc::SlaveTiming usual() {
  dc::SlaveTiming timing;
  timing.bus_cycle = timing.sync0.period = kMillisecond;
  timing.set_value = 400 * kMicrosecond;
  timing.wire = 10 * kMicrosecond;
  return timing;
}

/// The diagram painted, and whether a column of pixels beside an edge differs from the background.
class Painted {
 public:
  explicit Painted(const dc::SlaveTiming& timing, int width = 600) {
    diagram.setTiming(timing);
    diagram.resize(width, diagram.sizeHint().height());
    image = QImage(diagram.size(), QImage::Format_RGB32);
    diagram.render(&image);
  }
  [[nodiscard]] int coloured(const QColor& color) const {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == color ? 1 : 0;
    }
    return count;
  }
  TimingDiagram diagram;
  QImage image;
};

TEST(TimingDiagram, IsToScale) {
  const Painted painted(usual());
  const auto& diagram = painted.diagram;
  const auto width = diagram.xOf(kMillisecond) - diagram.xOf(0);
  EXPECT_GT(width, 300);
  EXPECT_NEAR(diagram.xOf(400 * kMicrosecond) - diagram.xOf(0), 0.4 * width, 1e-6);
  EXPECT_LE(diagram.xOf(kMillisecond), 600);
}

TEST(TimingDiagram, HasARowForTheLatchUnit) {
  auto timing = usual();
  timing.compute = 100 * kMicrosecond;
  const Painted without(timing);
  timing.latch = dc::SlaveTiming::Latch{.in_frames = true};
  const Painted with(timing);
  EXPECT_GT(with.diagram.sizeHint().height(), without.diagram.sizeHint().height());
  const auto color = plot_colors::trace(with.diagram.palette(), 2);
  EXPECT_EQ(without.coloured(color), 0);
  EXPECT_GT(with.coloured(color), 0);
  EXPECT_TRUE(with.diagram.described().contains(QStringLiteral("0x09AE"))) << qPrintable(with.diagram.described());
  EXPECT_FALSE(without.diagram.described().contains(QStringLiteral("atch")));
}

TEST(TimingDiagram, SaysWhatItDraws) {
  auto timing = usual();
  timing.sync1 = 100 * kMicrosecond;
  timing.compute = 500 * kMicrosecond;
  const Painted tight(timing);
  EXPECT_TRUE(tight.diagram.isTooTight());
  EXPECT_EQ(tight.diagram.accessibleDescription(), tight.diagram.described());
  for (const char* part : {"SYNC0", "SYNC1", "too little", "390.000"})
    EXPECT_TRUE(tight.diagram.described().contains(QLatin1String(part))) << part;
  timing.compute = 300 * kMicrosecond;
  const Painted fits(timing);
  EXPECT_FALSE(fits.diagram.described().contains(QLatin1String("too little")));
  const auto bad = theme::toneColor(fits.diagram.palette(), theme::Tone::kBad);
  EXPECT_GT(tight.coloured(bad), 100);
  EXPECT_EQ(fits.coloured(bad), 0);
}

/// What reaches beyond the end goes on at the beginning, and nothing is drawn outside.
TEST(TimingDiagram, TakesTimesBeyondTheCycle) {
  auto timing = usual();
  timing.delay = 990 * kMicrosecond;
  timing.wire = 30 * kMicrosecond;
  timing.compute = 3 * kMillisecond;
  for (const int width : {600, 200, 90}) {
    const Painted painted(timing, width);
    EXPECT_GT(painted.coloured(theme::toneColor(painted.diagram.palette(), theme::Tone::kBad)), 0) << width;
  }
}

TEST(TimingDiagram, WithoutSync0SaysSo) {
  TimingDiagram diagram;
  EXPECT_FALSE(diagram.accessibleDescription().isEmpty());
  diagram.setTiming(usual());
  const auto with = diagram.accessibleDescription();
  diagram.setTiming({});
  EXPECT_NE(diagram.accessibleDescription(), with);
  EXPECT_FALSE(diagram.timeline().margin);
}

class TheDcPage : public test::RunningWindow {
 protected:
  TimingDiagram& diagram() { return field<TimingDiagram>("slaveTiming"); }
  QString text(const char* name) { return field<QLabel>(name).text(); }
  void shiftBy(Nanoseconds time) {
    auto changed = project();
    auto& shift = changed.slaves[kServo].dc.sync0.shift;
    shift = shift.value_or(0) + time;
    workspace_.document().replace(QStringLiteral("shift"), changed);
  }
};

TEST_F(TheDcPage, ShowsTheCycleAsItIsSetAndFollowsEdits) {
  load();
  show(kServo, "slaveDcPage");
  ASSERT_TRUE(diagram().timeline().margin);
  const auto before = *diagram().timeline().margin;
  shiftBy(-100 * kMicrosecond);
  const auto is = [&](Nanoseconds margin) {
    return test::waitFor([this, margin] { return diagram().timeline().margin == margin; });
  };
  EXPECT_TRUE(is(before - 100 * kMicrosecond)) << *diagram().timeline().margin;
  workspace_.document().undoStack().undo();
  EXPECT_TRUE(is(before)) << *diagram().timeline().margin;
}

/// At each width of the window: somewhere all cards just fit beside each other.
TEST_F(TheDcPage, CardsStayWhereTheyAreWhileARegisterDiffers) {
  goOnline();
  show(kServo, "slaveDcPage");
  run(kSecond);
  std::vector<QPoint> places[2];
  for (auto& of : places) {
    for (int width = 1024; width <= 1600; width += 24) {
      window_.resize(width, 800);
      QApplication::processEvents();
      of.push_back(diagram().mapTo(&window_, QPoint()));
    }
    if (&of != places) break;
    shiftBy(-100 * kMicrosecond);
    ASSERT_TRUE(test::waitFor([this] {
      run(100 * kMillisecond);
      return text("register0990").contains(QStringLiteral("the slave has"));
    }));
  }
  for (std::size_t i = 0; i < places[0].size(); ++i) EXPECT_EQ(places[0][i].x(), places[1][i].x()) << i;
}

TEST_F(TheDcPage, ReadsItsRegistersBack) {
  goOnline();
  show(kServo, "slaveDcPage");
  run(kSecond);
  const auto compiled = text("register09A0");
  EXPECT_TRUE(compiled.contains(QStringLiteral("read back"))) << qPrintable(compiled);
  EXPECT_TRUE(text("register0980").contains(QStringLiteral("read back")));
  EXPECT_TRUE(text("register0990").contains(QStringLiteral("read back")));
  // The project is another by now than what was started: said, and what the slave has.
  shiftBy(-100 * kMicrosecond);
  EXPECT_TRUE(test::waitFor([this] {
    run(100 * kMillisecond);
    return text("register0990").contains(QStringLiteral("the slave has"));
  })) << qPrintable(text("register0990"));
  workspace_.live().shutDown();
  QApplication::processEvents();
  run(100 * kMillisecond);
  EXPECT_FALSE(text("register0980").contains(QStringLiteral("read back"))) << "nobody can be asked";
}

}  // namespace
}  // namespace syncline::ui
