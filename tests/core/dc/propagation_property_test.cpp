// SPDX-License-Identifier: Apache-2.0
// Delays recovered from what slaves of random segments latch, against the walk that produced it.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>

#include "dc/propagation_delay.h"
#include "protocol/dl_status.h"
#include "segment_truth.h"

namespace syncline::dc {
namespace {

struct Shape {
  int slaves = 200;
  bool without_dc = false;  // some slaves with two ports know no DC
  bool reversed = false;    // some cables are plugged the wrong way round
  std::uint32_t noise = 0;  // of every receive time, ns
};

constexpr std::array<unsigned, 3> kBranchOrder{3, 1, 2};

/// A tree in frame order: each slave is a leaf, a link of a line or a branch.
class Grower {
 public:
  Grower(const Shape& shape, std::uint64_t seed) : shape_(shape), random_(seed) {}

  SegmentTruth grow() {
    add({}, 0);
    // What the dice left out hangs behind the last slave, so that long segments occur.
    while (static_cast<int>(segment_.slaves.size()) < shape_.slaves) {
      const auto last = static_cast<std::uint16_t>(segment_.slaves.size() - 1);
      const auto before = segment_.slaves.size();
      add_children(last);
      if (segment_.slaves.size() == before) add(last, free_port(last));
    }
    segment_.walk();
    return std::move(segment_);
  }

 private:
  void add(std::optional<std::uint16_t> parent, unsigned port) {
    if (static_cast<int>(segment_.slaves.size()) >= shape_.slaves) return;
    const auto position = segment_.add(parent, port, dice(2, 600), kind(parent.has_value()), dice(0, 0xFFFF'FFFFU));
    auto& slave = segment_.slaves[position];
    slave.garbage = dice(0, 0xFFFF'FFFFU);
    // The way to the processing unit behind a closed port 0 shows only where there is a system time.
    if (shape_.reversed && slave.kind != DcKind::kReceiveTimesOnly && random_.uniform() < 0.2) {
      slave.entry = slave.kind == DcKind::kNone ? 1 : dice(1, 3);
    }
    if (depth_ < 30) add_children(position);
  }
  void add_children(std::uint16_t position) {
    ++depth_;
    const auto entry = segment_.slaves[position].entry;
    if (segment_.slaves[position].kind == DcKind::kNone) {
      if (random_.uniform() < 0.8) add(position, entry == 1 ? 0 : 1);
    } else if (entry != 0) {
      // The frame goes on through the ports behind the one that it came in by.
      const auto begin = static_cast<std::size_t>(std::ranges::find(kPortOrder, entry) - kPortOrder.begin());
      for (std::size_t step = 1; step < kPortOrder.size(); ++step) {
        if (random_.uniform() < 0.4) add(position, kPortOrder[(begin + step) % kPortOrder.size()]);
      }
    } else {
      const double branching = random_.uniform();
      for (const unsigned port : kBranchOrder) {
        if (random_.uniform() < (port == 1 ? 0.85 : branching * 0.3)) add(position, port);
      }
    }
    --depth_;
  }
  [[nodiscard]] unsigned free_port(std::uint16_t position) const {
    const auto& slave = segment_.slaves[position];
    if (slave.kind == DcKind::kNone && slave.entry == 1) return 0;
    return slave.entry == 1 ? 2 : 1;
  }
  DcKind kind(bool may_lack_dc) {
    if (!shape_.without_dc) return DcKind::kFull;
    const double chance = random_.uniform();
    if (may_lack_dc && chance < 0.3) return DcKind::kNone;
    return chance < 0.5 ? DcKind::kReceiveTimesOnly : DcKind::kFull;
  }
  std::uint32_t dice(std::uint32_t low, std::uint32_t high) {
    return low + static_cast<std::uint32_t>(random_.uniform() * (static_cast<double>(high - low) + 1.0));
  }

  Shape shape_;
  Random random_;
  SegmentTruth segment_;
  int depth_ = 0;
};

std::vector<DelayNode> with_noise(std::vector<DelayNode> nodes, std::uint32_t noise, std::uint64_t seed) {
  Random random(seed);
  for (auto& node : nodes) {
    for (auto& time : node.receive_time) time += static_cast<std::uint32_t>(random.uniform() * (noise + 1.0));
  }
  return nodes;
}

std::int64_t worst_error(const SegmentTruth& segment, const DelayResult& result) {
  std::int64_t worst = 0;
  for (std::size_t i = 0; i < segment.slaves.size(); ++i) {
    if (segment.slaves[i].kind == DcKind::kNone) {
      RC_ASSERT(!result.delay_ns[i]);
      continue;
    }
    RC_ASSERT(result.delay_ns[i].has_value());
    worst = std::max(worst, std::abs(std::int64_t{*result.delay_ns[i]} - segment.delay(i)));
    RC_ASSERT(result.entry_port[i] == segment.slaves[i].entry);
  }
  return worst;
}

std::uint64_t any_seed() { return *rc::gen::arbitrary<std::uint64_t>(); }
int any_size() { return *rc::gen::inRange(1, 201); }

TEST(PropagationDelayProperty, TreesOfDcSlavesAreExact) {
  EXPECT_TRUE(rc::check([] {
    const auto segment = Grower({any_size()}, any_seed()).grow();
    RC_ASSERT(worst_error(segment, propagation_delays(segment.nodes())) == 0);
  }));
}

TEST(PropagationDelayProperty, SlavesWithoutDcAndWithReceiveTimesOnlyAreExactToo) {
  EXPECT_TRUE(rc::check([] {
    const auto segment = Grower({any_size(), true}, any_seed()).grow();
    RC_ASSERT(worst_error(segment, propagation_delays(segment.nodes())) == 0);
  }));
}

TEST(PropagationDelayProperty, ReversedCablesAreFoundAndMeasured) {
  EXPECT_TRUE(rc::check([] {
    const bool without_dc = *rc::gen::arbitrary<bool>();
    const auto segment = Grower({any_size(), without_dc, true}, any_seed()).grow();
    const auto result = propagation_delays(segment.nodes());
    RC_ASSERT(worst_error(segment, result) <= 20);
    const auto reversed = std::count_if(segment.slaves.begin(), segment.slaves.end(), [&](const auto& slave) {
      // The entry of a leaf shows as its only port.
      return slave.entry != 0;
    });
    const auto told = std::count_if(result.findings.begin(), result.findings.end(), [](const auto& finding) {
      return finding.warning == DelayWarning::kReversedCable;
    });
    RC_ASSERT(reversed == told);
  }));
}

TEST(PropagationDelayProperty, NoiseOfTheStampsStaysNoiseOfTheDelays) {
  // One node adds half of the noise of two differences; it must not run away along a line.
  EXPECT_TRUE(rc::check([] {
    const auto segment = Grower({20}, any_seed()).grow();
    const auto result = propagation_delays(with_noise(segment.nodes(), 10, any_seed()));
    RC_ASSERT(worst_error(segment, result) <= 20 * 20);
    for (const auto& finding : result.findings) RC_ASSERT(finding.warning == DelayWarning::kReversedCable);
  }));
}

TEST(PropagationDelayProperty, ResultDoesNotDependOnTheClocks) {
  EXPECT_TRUE(rc::check([] {
    auto segment = Grower({any_size(), true}, any_seed()).grow();
    const auto before = propagation_delays(segment.nodes());
    Random random(any_seed());
    for (auto& slave : segment.slaves) {
      slave.clock_offset = static_cast<std::uint32_t>(random.next());
      slave.garbage = static_cast<std::uint32_t>(random.next());
    }
    segment.walk();
    const auto after = propagation_delays(segment.nodes());
    RC_ASSERT(before.delay_ns == after.delay_ns);
    RC_ASSERT(before.entry_port == after.entry_port);
  }));
}

TEST(PropagationDelayProperty, ArbitraryReadingsNeverCrash) {
  EXPECT_TRUE(rc::check([] {
    Random random(any_seed());
    std::vector<DelayNode> nodes(static_cast<std::size_t>(any_size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      auto& node = nodes[i];
      node.kind = static_cast<DcKind>(random.next() % 3);
      for (std::size_t port = 0; port < 4; ++port) {
        node.active[port] = random.next() % 2 == 0;
        node.receive_time[port] = static_cast<std::uint32_t>(random.next());
      }
      if (i > 0) node.parent = static_cast<std::uint16_t>(random.next() % i);
      node.parent_port = static_cast<std::uint8_t>(random.next() % 4);
    }
    RC_ASSERT(propagation_delays(nodes).delay_ns.size() == nodes.size());
  }));
}

}  // namespace
}  // namespace syncline::dc
