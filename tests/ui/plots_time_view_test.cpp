// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/time_view.h"

#include <gtest/gtest.h>

namespace syncline::ui {
namespace {

using Mode = TimeView::Mode;
constexpr Nanoseconds kViewStart = 830'000'000 * kSecond;

class TimeViewTest : public testing::Test {
 protected:
  void SetUp() override {
    view.setSpan(10 * kSecond);
    view.setBounds(kViewStart, kViewStart + 60 * kSecond);
  }
  TimeView view;
};

TEST_F(TimeViewTest, FollowsTheNewestSample) {
  EXPECT_EQ(view.mode(), Mode::kLive);
  EXPECT_EQ(view.end(), kViewStart + 60 * kSecond);
  view.setBounds(kViewStart, kViewStart + 61 * kSecond);
  EXPECT_EQ(view.begin(), kViewStart + 51 * kSecond);
  EXPECT_EQ(view.behind(), 0);
}

/// A recording is shown whole; what is followed afterwards has the span that it had.
TEST_F(TimeViewTest, WhatIsFollowedAgainHasItsSpan) {
  view.reset();
  view.setFollowable(false);
  view.setBounds(kViewStart, kViewStart + 3600 * kSecond);
  view.showAll();
  EXPECT_EQ(view.span(), 3600 * kSecond);
  view.reset();
  view.setFollowable(true);
  EXPECT_EQ(view.span(), 10 * kSecond);
}

TEST_F(TimeViewTest, TimesAreCountedFromTheirOrigin) {
  EXPECT_EQ(view.origin(), kViewStart);
  view.setOrigin(kViewStart - 5 * kSecond);
  view.setBounds(kViewStart + kSecond, kViewStart + 70 * kSecond);
  EXPECT_EQ(view.origin(), kViewStart - 5 * kSecond);
  view.reset();
  EXPECT_EQ(view.origin(), view.first());
}

TEST_F(TimeViewTest, PanLeavesFollowingAndHoldsWhileDataArrive) {
  view.pan(-5 * kSecond);
  EXPECT_EQ(view.mode(), Mode::kHistory);
  const auto begin = view.begin();
  view.setBounds(kViewStart, kViewStart + 100 * kSecond);
  EXPECT_EQ(view.begin(), begin);
  EXPECT_EQ(view.behind(), 45 * kSecond);
}

TEST_F(TimeViewTest, ZoomKeepsThePlaceUnderThePointer) {
  const auto anchor = view.begin() + 3 * kSecond;
  view.zoom(0.5, anchor);
  EXPECT_EQ(view.span(), 5 * kSecond);
  EXPECT_EQ(anchor - view.begin(), 1500 * kMillisecond);
}

TEST_F(TimeViewTest, GoingLiveAgainKeepsTheZoomWidth) {
  view.zoom(0.25, view.begin());
  view.setBounds(kViewStart, kViewStart + 90 * kSecond);
  view.goLive();
  EXPECT_EQ(view.mode(), Mode::kLive);
  EXPECT_EQ(view.span(), 2500 * kMillisecond);
  EXPECT_EQ(view.end(), kViewStart + 90 * kSecond);
}

TEST_F(TimeViewTest, FrozenPictureStandsStill) {
  int changes = 0;
  view.freeze();
  QObject::connect(&view, &TimeView::changed, [&] { ++changes; });
  view.setBounds(kViewStart, kViewStart + 70 * kSecond);
  EXPECT_EQ(changes, 0);
  EXPECT_EQ(view.end(), kViewStart + 60 * kSecond);
  EXPECT_EQ(view.behind(), 10 * kSecond);
  view.pan(-kSecond);
  EXPECT_EQ(view.mode(), Mode::kFrozen) << "looking around does not thaw";
}

TEST_F(TimeViewTest, DoesNotGetLostBesideTheData) {
  view.pan(-1000 * kSecond);
  EXPECT_GT(view.end(), kViewStart);
  view.pan(5000 * kSecond);
  EXPECT_LT(view.begin(), kViewStart + 60 * kSecond);
  view.zoom(1e12, kViewStart);
  EXPECT_EQ(view.span(), TimeView::kMaxSpan);
  view.zoom(1e-15, kViewStart);
  EXPECT_EQ(view.span(), TimeView::kMinSpan);
}

TEST_F(TimeViewTest, WindowLengthDoesNotStopFollowing) {
  view.setSpan(kSecond);
  EXPECT_EQ(view.mode(), Mode::kLive);
  EXPECT_EQ(view.end(), kViewStart + 60 * kSecond);
}

}  // namespace
}  // namespace syncline::ui
