// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/clock_segment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "master/exchange/bus.h"
#include "master/exchange/slave_address.h"
#include "master/scan/bus_scanner.h"
#include "master/scan/topology.h"
#include "protocol/port_descriptor.h"
#include "protocol/registers.h"

namespace syncline {
namespace {

dc::DcKind kind_of(DcCapability capability) {
  if (has_system_time(capability)) return dc::DcKind::kFull;
  return capability == DcCapability::kNone ? dc::DcKind::kNone : dc::DcKind::kReceiveTimesOnly;
}

/// Positions with every slave behind the one that it hangs at, and children in the order in which a frame visits them.
std::vector<std::uint16_t> tree_order(std::span<const SlaveWiring> wiring, std::span<const dc::DelayNode> nodes) {
  constexpr unsigned kNoPlace = 4;
  const auto place = [&](std::uint16_t child) {
    const auto& previous = *wiring[child].previous;
    const auto entry = std::ranges::find(kPortOrder, wiring[previous.position].entry_port) - kPortOrder.begin();
    const auto port = std::ranges::find(kPortOrder, previous.port) - kPortOrder.begin();
    return port == kNoPlace ? kNoPlace : static_cast<unsigned>((port - entry + 4) % 4);
  };
  std::vector<std::vector<std::uint16_t>> children(nodes.size());
  std::vector<std::uint16_t> open, order;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const auto position = static_cast<std::uint16_t>(i);
    if (const auto& previous = wiring[i].previous) {
      children[previous->position].push_back(position);
    } else {
      open.push_back(position);
    }
  }
  while (!open.empty()) {
    const auto position = open.back();
    open.pop_back();
    order.push_back(position);
    auto& list = children[position];
    std::ranges::sort(list, [&](auto a, auto b) { return place(a) > place(b); });
    open.insert(open.end(), list.begin(), list.end());
  }
  return order;
}

bool came_back(const dc::DelayNode& node, unsigned port, unsigned entry) {
  constexpr std::int32_t kLongest = 1'000'000;  // ns, for the longest segment
  const auto away = static_cast<std::int32_t>(node.receive_time[port] - node.receive_time[entry]);
  return node.kind != dc::DcKind::kNone && away > 0 && away <= kLongest;
}

}  // namespace

bool has_system_time(DcCapability capability) {
  return capability == DcCapability::kSystemTime32 || capability == DcCapability::kSystemTime64;
}

Result<ClockSegment> read_clock_segment(Bus& bus, std::span<const SlaveAddress> slaves) {
  auto capabilities = probe_dc(bus, slaves);
  if (!capabilities) return tl::unexpected(capabilities.error());
  std::vector<std::array<std::uint8_t, 2>> bytes(slaves.size());
  std::vector<std::uint8_t> kinds(slaves.size());
  std::vector<Datagram> reads;
  for (std::size_t i = 0; i < slaves.size(); ++i) reads.push_back(slaves[i].read(reg::kDlStatus, bytes[i]));
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    reads.push_back(slaves[i].read(reg::kPortDescriptor, std::span(&kinds[i], 1)));
  }
  std::uint8_t type = 0;
  reads.push_back({.command = Command::kBrd, .address = device_address(0, reg::kType), .data = std::span(&type, 1)});
  if (auto status = bus.transact(reads); !status) return tl::unexpected(status.error());
  ClockSegment segment;
  segment.whole = reads.back().wkc == slaves.size();
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (reads[i].wkc == 0) return fail(ErrorCode::kNoResponse, fmt::format("slave {}", i));
    const DlStatus status{load_le<std::uint16_t>(bytes[i])};
    segment.dl_status.push_back(status);
    dc::DelayNode node;
    node.kind = kind_of((*capabilities)[i]);
    for (unsigned port = 0; port < kPortCount; ++port) {
      node.active[port] = status.active(port);
      node.ebus[port] = port_descriptor(kinds[i], port) == PortDescriptor::kEbus;  // nothing where it was not answered
    }
    segment.nodes.push_back(node);
  }
  segment.capabilities = std::move(*capabilities);
  return segment;
}

std::vector<SlaveWiring> segment_wiring(std::span<const dc::DelayNode> nodes, std::span<const DlStatus> dl_status) {
  std::vector<PortReport> reports;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    reports.push_back({dl_status[i], {}});
    if (nodes[i].kind != dc::DcKind::kNone) reports.back().receive_times = nodes[i].receive_time;
  }
  return find_wiring(reports);
}

dc::DelayResult segment_delays(std::span<const dc::DelayNode> nodes, std::span<const SlaveWiring> wiring, bool whole,
                               const dc::DelayOptions& options) {
  const auto order = tree_order(wiring, nodes);
  std::vector<std::uint16_t> place(nodes.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<std::uint16_t>(k);

  std::vector<dc::DelayNode> tree;
  std::vector<dc::DelayFinding> of_ports;
  for (const auto position : order) {
    auto node = nodes[position];
    for (unsigned port = 0; port < kPortCount; ++port) {
      if (((wiring[position].unexplained_ports >> port) & 1U) == 0) continue;
      // The frame that was latched came back there: slaves that nobody asked about.
      if (!whole && came_back(node, port, wiring[position].entry_port)) continue;
      node.active[port] = false;
      of_ports.push_back({position, dc::DelayWarning::kUnexplainedPort, static_cast<std::int64_t>(port)});
    }
    for (unsigned port = 0; port < kPortCount; ++port) {
      node.untimed[port] = ((wiring[position].untimed_ports >> port) & 1U) != 0;
      if (node.untimed[port])
        of_ports.push_back({position, dc::DelayWarning::kUntimedPort, static_cast<std::int64_t>(port)});
    }
    node.entry_port = wiring[position].entry_port;
    if (const auto& previous = wiring[position].previous) {
      node.parent = place[previous->position];
      node.parent_port = previous->port;
    }
    tree.push_back(node);
  }
  const auto found = dc::propagation_delays(tree, options);
  dc::DelayResult result;
  result.delay_ns.resize(nodes.size());
  result.entry_port.resize(nodes.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.delay_ns[order[k]] = found.delay_ns[k];
    result.entry_port[order[k]] = found.entry_port[k];
  }
  for (auto finding : found.findings) {
    finding.position = order[finding.position];
    result.findings.push_back(finding);
  }
  result.findings.insert(result.findings.end(), of_ports.begin(), of_ports.end());
  return result;
}

bool matters_behind(std::size_t leader, const dc::DelayFinding& finding) {
  return finding.warning != dc::DelayWarning::kUnmeasuredWay || finding.position > leader;
}

}  // namespace syncline
