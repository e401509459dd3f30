// SPDX-License-Identifier: Apache-2.0
#include "ui/text/step_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <cmath>
#include <memory>
#include <vector>

#include "channels/cycle_sample.h"
#include "ui/panels/live_strip.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;

constexpr Nanoseconds kStepBegin = 830'000'000 * kSecond;

NetworkConfig steppedNetwork(DcmMode mode) {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kMillisecond;
  config.slaves.emplace_back().name = "1 Drive";
  config.dc.enabled = true;
  config.dc.dcm.mode = mode;
  return config;
}

/// In the second second the error steps by 8 us, and falls by e in each 20 ms.
std::unique_ptr<RunRecord> steppedRun(DcmMode mode) {
  auto record = std::make_unique<RunRecord>(steppedNetwork(mode));
  std::vector<CycleSample> samples(3'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    auto& sample = samples[i];
    sample.cycle = i;
    sample.send_time = kStepBegin + static_cast<Nanoseconds>(i) * kMillisecond;
    sample.flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
    const double step = i < 1'000 ? 0 : 8'000 * std::exp(-static_cast<double>(i - 1'000) / 20);
    sample.dcm_error_ns = static_cast<std::int32_t>(std::lround(step)) + (i % 3 == 0 ? 4 : -2);
  }
  record->add(samples);
  return record;
}

std::string said(const RunRecord& record, Nanoseconds from, Nanoseconds to) {
  return stepText(record, kStepBegin + from, kStepBegin + to).replace(QChar(0x00A0), u' ').toStdString();
}

TEST(StepText, TellsSizeOvershootAndSettlingTimeAndWhatTheControllerWouldDo) {
  const auto record = steppedRun(DcmMode::kMasterShift);
  const auto text = said(*record, kSecond, 2 * kSecond);
  EXPECT_THAT(text, HasSubstr("step +8.0"));
  EXPECT_THAT(text, HasSubstr("overshoot 0 %, settled after 60.000 ms"));
  EXPECT_THAT(text, HasSubstr("(its controller without noise: overshoot"));
  const auto bus = steppedRun(DcmMode::kBusShift);
  EXPECT_THAT(said(*bus, kSecond, 2 * kSecond), testing::Not(HasSubstr("its controller")));
}

TEST(StepText, SaysNothingWhereNoStepIsSeenAndNothingOfAControllerThatWasChanged) {
  const auto record = steppedRun(DcmMode::kMasterShift);
  EXPECT_EQ(said(*record, 0, 900 * kMillisecond), "");
  EXPECT_EQ(said(*record, 2 * kSecond, 3 * kSecond), "");
  Snapshot now;
  now.online = true;
  now.dcm.times_configured = 1;
  record->add(now);
  const auto text = said(*record, kSecond, 2 * kSecond);
  EXPECT_THAT(text, HasSubstr("settled after"));
  EXPECT_THAT(text, testing::Not(HasSubstr("its controller")));
}

TEST(StepText, StandsBetweenTheCursorsInThePlotOfTheError) {
  const auto record = steppedRun(DcmMode::kMasterShift);
  LiveStrip strip;
  strip.resize(1280, 230);
  strip.setRecord(record.get());
  strip.show();
  strip.cursors()->set(CursorSet::kA, kStepBegin + kSecond);
  strip.cursors()->set(CursorSet::kB, kStepBegin + 2 * kSecond);
  strip.refresh();
  QApplication::processEvents();
  const auto text = strip.panels()[2]->readout().replace(QChar(0x00A0), u' ').toStdString();
  EXPECT_THAT(text, HasSubstr("mean"));
  EXPECT_THAT(text, HasSubstr("settled after 60.000 ms"));
  strip.setRecord(nullptr);
}

TEST(SpreadText, IsNeverNarrowerThanItIs) {
  EXPECT_EQ(withSpreadText(QStringLiteral("12"), std::nullopt), QStringLiteral("12"));
  EXPECT_EQ(withSpreadText(QStringLiteral("12"), 0.2).replace(QChar(0x00A0), u' '), QStringLiteral("12 \u00B1 1 ns"));
  EXPECT_EQ(withSpreadPpmText(12.3456, 0.0042).replace(QChar(0x00A0), u' '),
            QStringLiteral("+12.346 \u00B1 0.005 ppm"));
  EXPECT_EQ(withSpreadPpmText(-0.001, 0.2).replace(QChar(0x00A0), u' '), QStringLiteral("0.00 \u00B1 0.20 ppm"));
  EXPECT_EQ(withSpreadPpmText(5, std::nullopt), ppmText(5));
  EXPECT_EQ(decadeText(0), QStringLiteral("1"));
  EXPECT_EQ(decadeText(6), QStringLiteral("10\u207B\u2076"));
}

}  // namespace
}  // namespace syncline::ui
