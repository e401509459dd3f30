// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>

#include "capture/pcap_reader.h"
#include "capture/recorded_bus.h"
#include "dc/propagation_delay.h"
#include "findings/error_text.h"
#include "master/scan/topology.h"
#include "protocol/frame.h"
#include "protocol/port_descriptor.h"
#include "protocol/registers.h"
#include "support/byte_order.h"
#include "support/sample_folder.h"

/// Receive times as a master recorded them, of simulated slaves with ours and of real ones with others, against the
/// delays that this master then wrote.
namespace syncline {
namespace {

struct Recording {
  std::vector<RecordedSlave> slaves;
  std::map<std::size_t, std::uint32_t> written;  // SystemTimeDelay by position
  /// Receive times of all ports of the latest latch, where they were read at once.
  std::map<std::size_t, std::array<std::uint32_t, 4>> received;
};

Recording read_capture(const std::string& path) {
  Recording recording;
  auto reader = PcapReader::open(path);
  EXPECT_TRUE(reader) << describe(reader.error());
  BusRecorder recorder;
  std::map<std::uint16_t, std::size_t> position_of;  // by station address
  while (auto frame = reader->next().value_or(std::nullopt)) {
    recorder.add(frame->bytes);
    FrameReader datagrams(frame->bytes);
    while (const auto datagram = datagrams.next()) {
      const auto& header = datagram->header;
      if (header.command == Command::kApwr && header.ado() == reg::kStationAddress && datagram->data.size() == 2) {
        const auto position = static_cast<std::uint16_t>(-header.adp());  // as it was sent; it comes back later
        position_of.try_emplace(load_le<std::uint16_t>(datagram->data), position);
      }
      if (header.command == Command::kFpwr && header.ado() == reg::kSystemTimeDelay && datagram->data.size() == 4) {
        if (const auto found = position_of.find(header.adp()); found != position_of.end()) {
          recording.written[found->second] = load_le<std::uint32_t>(datagram->data);
        }
      }
      if (header.command == Command::kFprd && header.ado() == reg::kReceiveTimePort0 && datagram->data.size() == 16 &&
          datagram->wkc() == 1) {
        const auto found = position_of.find(header.adp());
        for (std::size_t port = 0; found != position_of.end() && port < 4; ++port) {
          recording.received[found->second][port] = load_le<std::uint32_t>(datagram->data.subspan(4 * port));
        }
      }
    }
  }
  recording.slaves = recorder.slaves();
  return recording;
}

template <class T>
T value_at(const RecordedSlave& slave, std::uint16_t address) {
  std::array<std::uint8_t, sizeof(T)> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = slave.memory.at(address + i);
  return load_le<T>(bytes);
}

class CapturedDelays : public testing::TestWithParam<test::SampleRoot> {};
INSTANTIATE_TEST_SUITE_P(Roots, CapturedDelays, testing::ValuesIn(test::sample_roots()), test::SampleRootName());

TEST_P(CapturedDelays, AreThoseThatTheRecordedMasterWrote) {
  const auto folder = GetParam().folder / "pcap";
  std::size_t compared = 0, busses = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".pcapng") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const auto recording = read_capture(entry.path().string());
    if (recording.written.empty()) continue;
    std::vector<PortReport> reports;
    for (const auto& slave : recording.slaves) {
      if (!slave.knows(reg::kDlStatus, 2)) break;
      PortReport report{DlStatus{value_at<std::uint16_t>(slave, reg::kDlStatus)}, std::nullopt};
      if (const auto latest = recording.received.find(reports.size()); latest != recording.received.end()) {
        report.receive_times = latest->second;
      } else if (slave.knows(reg::kReceiveTimePort0, 16)) {
        auto& times = report.receive_times.emplace();
        for (unsigned port = 0; port < times.size(); ++port) {
          times[port] = value_at<std::uint32_t>(slave, static_cast<std::uint16_t>(reg::kReceiveTimePort0 + 4 * port));
        }
      }
      reports.push_back(report);
    }
    if (reports.size() != recording.slaves.size()) continue;  // that master did not look at the ports
    const auto wiring = find_wiring(reports);
    std::vector<dc::DelayNode> nodes;
    for (std::size_t i = 0; i < reports.size(); ++i) {
      dc::DelayNode node;
      const auto& slave = recording.slaves[i];
      const auto kinds =
          slave.knows(reg::kPortDescriptor, 1) ? value_at<std::uint8_t>(slave, reg::kPortDescriptor) : std::uint8_t{0};
      for (unsigned port = 0; port < kPortCount; ++port) {
        node.active[port] = reports[i].dl_status.active(port);
        node.ebus[port] = port_descriptor(kinds, port) == PortDescriptor::kEbus;
      }
      if (reports[i].receive_times) {
        node.kind = dc::DcKind::kFull;
        node.receive_time = *reports[i].receive_times;
      }
      if (wiring[i].previous) {
        node.parent = wiring[i].previous->position;
        node.parent_port = wiring[i].previous->port;
      }
      nodes.push_back(node);
    }
    // The others' master knows of no tDiff.
    const auto delays = dc::propagation_delays(nodes, GetParam().own ? dc::DelayOptions{} : dc::DelayOptions{0});
    ++busses;
    for (const auto& [position, written] : recording.written) {
      if (!delays.delay_ns[position]) continue;
      EXPECT_NEAR(*delays.delay_ns[position], written, 5) << "slave " << position;
      compared += written > 0 ? 1 : 0;
    }
  }
  RecordProperty("busses", static_cast<int>(busses));
  EXPECT_GE(busses, GetParam().own ? 1U : 4U);
  EXPECT_GE(compared, 4U) << "delays that are not zero";
}

}  // namespace
}  // namespace syncline
