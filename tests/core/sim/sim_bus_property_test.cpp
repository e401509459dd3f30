// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/core/sim/sim_probe.h"

/// Whatever comes in, a segment answers or does not; it reads and writes nothing but the frame.
namespace syncline::test {
namespace {

const SimConfig& segment() {
  static const SimConfig config = [] {
    auto made = line(
        {sim_slave("SL-1100"), sim_slave("SL-2002"), sim_slave("SL-SV7", "servo-y"), sim_slave("SL-XE2", "drive-c")});
    made.slaves[1].dc = {false, true, true};
    made.slaves[3].dc = {true, true, false};
    made.slaves[2].sii = {kMillisecond, 3 * kMillisecond, false};
    made.faults.push_back({FaultKind::kBitErrors, 2, 0, 0, 3});
    made.faults.push_back({FaultKind::kLoseFrames, 3, 0, 0, 2});
    return made;
  }();
  return config;
}

/// Addresses where something happens, with neighbours.
rc::Gen<std::uint16_t> interesting_address() {
  const auto near = [](std::uint16_t start, std::uint16_t size) {
    return rc::gen::map(rc::gen::inRange<unsigned>(0, size),
                        [start](unsigned offset) { return static_cast<std::uint16_t>(start + offset); });
  };
  return rc::gen::oneOf(near(0x0000, 0x0140), near(0x0300, 0x20), near(0x0400, 0x50), near(0x0500, 0x10),
                        near(0x0600, 0x100), near(0x0800, 0x80), near(0x0900, 0x100), near(0x0FF0, 0x400),
                        near(0xFF00, 0xFF), rc::gen::arbitrary<std::uint16_t>());
}

std::vector<std::uint8_t> random_frame() {
  FrameBuilder builder;
  const auto count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i) {
    const auto command = static_cast<Command>(*rc::gen::inRange(0, 18));
    const auto adp = *rc::gen::element<std::uint16_t>(0, 0xFFFF, 0xFFFE, 0xFFFD, 1001, 0x1234);
    const auto data = *rc::gen::container<std::vector<std::uint8_t>>(*rc::gen::inRange<std::size_t>(0, 200),
                                                                     rc::gen::arbitrary<std::uint8_t>());
    (void)builder.add(command, static_cast<std::uint8_t>(i), device_address(adp, *interesting_address()), data);
  }
  const auto frame = builder.finish();
  return {frame.begin(), frame.end()};
}

/// Runs the frames on a segment of its own; everything that came back, in a row.
std::vector<std::uint8_t> answers(const std::vector<std::vector<std::uint8_t>>& frames) {
  auto now = VirtualClock::kDefaultStart;
  auto bus = std::move(sim::SimBus::create(segment(), now).value());
  std::vector<std::uint8_t> all;
  for (auto frame : frames) {
    const auto returned = bus->execute(frame, now);
    all.push_back(returned.lost ? 1 : 0);
    if (!returned.lost) {
      EXPECT_GT(returned.arrival_time, now);
      all.insert(all.end(), frame.begin(), frame.end());
    }
    now += 700 * kMicrosecond;
    bus->advance_to(now);
  }
  return all;
}

RC_GTEST_PROP(SimBusProperty, AnyCommandAnywhereIsHarmlessAndRepeatable, ()) {
  std::vector<std::vector<std::uint8_t>> frames;
  const auto count = *rc::gen::inRange(1, 12);
  for (int i = 0; i < count; ++i) frames.push_back(random_frame());
  RC_ASSERT(answers(frames) == answers(frames));
}

RC_GTEST_PROP(SimBusProperty, DamagedFramesAreHarmless, ()) {
  std::vector<std::vector<std::uint8_t>> frames;
  for (int i = 0; i < 4; ++i) {
    auto frame = random_frame();
    const auto hits = *rc::gen::inRange(1, 8);
    for (int hit = 0; hit < hits; ++hit)
      frame[*rc::gen::inRange<std::size_t>(12, frame.size())] = *rc::gen::arbitrary<std::uint8_t>();
    frame.resize(*rc::gen::inRange<std::size_t>(0, frame.size() + 1));
    frame.shrink_to_fit();  // so that a sanitizer sees a read behind it
    frames.push_back(std::move(frame));
  }
  RC_ASSERT(answers(frames) == answers(frames));
}

RC_GTEST_PROP(SimBusProperty, RandomBytesAreHarmless, (const std::vector<std::uint8_t>& bytes)) {
  auto ethercat = bytes;
  if (ethercat.size() >= 14) {
    ethercat[12] = 0x88;
    ethercat[13] = 0xA4;
  }
  RC_ASSERT(answers({bytes, ethercat}) == answers({bytes, ethercat}));
}

}  // namespace
}  // namespace syncline::test
