// SPDX-License-Identifier: Apache-2.0
#include "sim/segment.h"

#include "protocol/dl_status.h"

namespace syncline::sim {
namespace {

constexpr double kNsPerMetre = 5.0;

class Walk {
 public:
  Walk(std::span<const SimSlaveConfig> slaves, std::span<const SlaveLink> links) : slaves_(slaves), links_(links) {}

  SegmentPath run() {
    if (!slaves_.empty() && reachable(0)) {
      const double cable = slaves_[0].cable_m * kNsPerMetre;
      path_.return_ns = visit(0, cable) + cable;
    }
    return std::move(path_);
  }

 private:
  [[nodiscard]] bool reachable(std::size_t i) const { return links_[i].cable && links_[i].power; }

  /// The frame arrives at port 0 at `time`; gives the time at which it leaves port 0 again.
  double visit(std::size_t i, double time) {
    path_.passages.push_back({static_cast<std::uint16_t>(i), 0, true, time});
    double out = time + slaves_[i].processing_delay_ns;
    for (std::size_t order = 1; order < kPortOrder.size(); ++order) {
      for (std::size_t child = i + 1; child < slaves_.size(); ++child) {
        if (slaves_[child].parent != i || slaves_[child].parent_port != kPortOrder[order] || !reachable(child)) continue;
        const double cable = slaves_[child].cable_m * kNsPerMetre;
        const double back = visit(child, out + cable) + cable;
        path_.passages.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint8_t>(kPortOrder[order]), false, back});
        out = back + slaves_[i].forwarding_delay_ns;
        break;
      }
    }
    return out;
  }

  std::span<const SimSlaveConfig> slaves_;
  std::span<const SlaveLink> links_;
  SegmentPath path_;
};

}  // namespace

SegmentPath segment_path(std::span<const SimSlaveConfig> slaves, std::span<const SlaveLink> links) {
  return Walk(slaves, links).run();
}

}  // namespace syncline::sim
