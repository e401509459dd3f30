// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/sim_config.h"
#include "protocol/coe.h"
#include "protocol/mailbox.h"
#include "tests/core/sim/sim_probe.h"

namespace syncline::test {

/// A drive alone on the bus: its mailbox, its states, and frames that arrive when the test wants them.
class DriveBed {
 public:
  explicit DriveBed(const std::string& type, std::vector<FaultConfig> faults = {}, double ppm = 0,
                    sim::SimBus::Work work = sim::SimBus::Work::kAtOnce)
      : device(sim_slave(type).device), probe(make(type, std::move(faults), ppm), work) {
    for (unsigned i = 0; i < 2; ++i) {
      const auto& sm = device.sync_managers[i];
      probe.set_sync_manager(0, i, sm.start_address, 128, sm.control_byte);
    }
    EXPECT_EQ(probe.request(0, 2), 2);
  }

  // ---- objects ----
  std::optional<coe::Response> sdo(const coe::Request& request) {
    MailboxMessage mail;
    mail.counter = counter_ = next_mailbox_counter(counter_);
    mail.data = coe::encode(request);
    EXPECT_EQ(probe.write(0, device.sync_managers[0].start_address, mail.encode(128)).wkc, 1);
    for (;;) {
      probe.pass(400 * kMicrosecond);
      const auto reply = probe.read(0, device.sync_managers[1].start_address, 128);
      if (reply.wkc == 0) return std::nullopt;
      const auto decoded = MailboxMessage::decode(reply.data);
      if (!decoded) return std::nullopt;
      const auto response = coe::decode_response(decoded->data);
      if (!response) return std::nullopt;
      if (!std::holds_alternative<coe::Emergency>(*response)) return *response;  // emergencies come in between
    }
  }
  std::uint32_t read(std::uint16_t index, std::uint8_t sub_index) {
    const auto response = sdo(coe::UploadRequest{{index, sub_index}, false});
    if (!response || !std::holds_alternative<coe::UploadResponse>(*response)) return 0xDEADBEEF;
    auto data = std::get<coe::UploadResponse>(*response).data;
    data.resize(4);
    return load_le<std::uint32_t>(data);
  }
  /// An abort code, or 0.
  std::uint32_t write(std::uint16_t index, std::uint8_t sub_index, std::vector<std::uint8_t> data) {
    const auto size = static_cast<std::uint32_t>(data.size());
    const auto response = sdo(coe::DownloadRequest{{index, sub_index}, false, true, size, std::move(data)});
    if (!response) return 1;
    const auto* abort = std::get_if<coe::Abort>(&*response);
    return abort == nullptr ? 0 : abort->code;
  }

  // ---- states ----
  void start_sync0(std::uint32_t ns, std::optional<std::uint32_t> sync1 = std::nullopt) {
    cycle = ns;
    first_sync = probe.read(0, reg::kSystemTime, 8).value<std::uint64_t>() + 5 * kMillisecond;
    probe.write(0, reg::kSync0CycleTime, le_bytes(ns));
    probe.write(0, reg::kStartTimeCyclicOperation, le_bytes(first_sync));
    if (sync1) probe.write(0, reg::kSync1CycleTime, le_bytes(*sync1));
    probe.write(0, reg::kCyclicUnitControl, {0x00, static_cast<std::uint8_t>(sync1 ? 0x07 : 0x03)});
  }
  std::uint16_t to_safeop() {
    for (const unsigned i : {2U, 3U}) {
      const auto& sm = device.sync_managers[i];
      probe.set_sync_manager(0, i, sm.start_address, static_cast<std::uint16_t>(length(i)), sm.control_byte);
    }
    return probe.request(0, 4);
  }
  /// With frames that come early enough, until the PLL has locked.
  std::uint16_t to_op() {
    if (const auto status = to_safeop(); status != 4) return status;
    outputs();
    probe.pass(500 * kMillisecond);
    probe.write(0, reg::kAlControl, le_bytes(std::uint16_t{8}));
    cycles(3);
    return status();
  }
  [[nodiscard]] std::size_t length(unsigned manager) const {
    std::uint32_t bits = 0;
    for (const auto& pdo : device.pdos(manager == 2 ? PdoDirection::kRx : PdoDirection::kTx)) {
      if (pdo.sync_manager) bits += pdo.bit_length();
    }
    return (bits + 7) / 8;
  }
  std::uint16_t status() { return probe.read(0, reg::kAlStatus, 2).value<std::uint16_t>(); }

  // ---- process data ----
  void outputs() {
    std::vector<std::uint8_t> bytes(length(2));
    store_le(std::span(bytes).first(2), controlword);
    store_le(std::span(bytes).subspan(2, 4), static_cast<std::uint32_t>(target));
    if (type_offset() != 0) bytes[type_offset()] = mode;
    probe.write(0, device.sync_managers[2].start_address, std::move(bytes));
  }
  std::vector<std::uint8_t> inputs() { return probe.read(0, device.sync_managers[3].start_address, length(3)).data; }
  /// Statusword and actual position come first with both drives.
  std::uint16_t statusword() { return load_le<std::uint16_t>(inputs()); }
  std::int32_t position() {
    return static_cast<std::int32_t>(load_le<std::uint32_t>(std::span(std::as_const(last_ = inputs())).subspan(2)));
  }

  /// True time of the next SYNC0.
  Nanoseconds next_sync() {
    probe.bus->advance_to(probe.now);
    const auto since = static_cast<Nanoseconds>(probe.bus->system_time(0) - first_sync);
    const auto period = static_cast<Nanoseconds>(cycle);
    return probe.now + (since < 0 ? -since : period - since % period);
  }
  /// The outputs are sent `lead` ns before a SYNC0.
  void frame(Nanoseconds lead) {
    probe.now += 1;
    auto time = next_sync() - lead;
    while (time < probe.now) time += cycle;
    probe.pass(time - probe.now);
    outputs();
  }
  void cycles(int count, Nanoseconds lead = 0) {
    for (int i = 0; i < count; ++i) frame(lead != 0 ? lead : cycle * 2 / 3);
  }
  /// Leaves a cycle without outputs, and stands behind its SYNC0.
  void lose() {
    probe.now += 1;
    probe.pass(next_sync() + cycle - 10 * kMicrosecond - probe.now);
  }

  DeviceDescription device;
  SimProbe probe;
  std::uint32_t cycle = 1'000'000;
  std::uint64_t first_sync = 0;
  std::uint16_t controlword = 0;
  std::int32_t target = 0;
  std::uint8_t mode = 8;

 private:
  static SimConfig make(const std::string& type, std::vector<FaultConfig> faults, double ppm) {
    auto slave = sim_slave(type, type == "SL-XE2" ? "drive-c" : "servo-y");
    slave.oscillator.ppm = ppm;
    auto config = line({slave});
    config.faults = std::move(faults);
    return config;
  }
  /// Of the modes of operation in the default PDOs.
  std::size_t type_offset() const { return device.type == "SL-SV7" ? 12 : 6; }

  std::uint8_t counter_ = 0;
  std::vector<std::uint8_t> last_;
};

}  // namespace syncline::test
