// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "protocol/datagram.h"

namespace syncline {

/// What a capture tells of one slave.
struct RecordedSlave {
  std::map<std::uint32_t, std::uint8_t> memory;  // bytes that were read or written with a working counter
  std::map<std::uint32_t, std::uint16_t> sii;    // EEPROM by word address
  bool reads_8_bytes = false;                    // of the EEPROM at a time
  /// Of all slaves together: bytes that a broadcast has written, so that every slave has them. Their values are not
  /// known.
  std::shared_ptr<const std::set<std::uint32_t>> written_to_all;

  [[nodiscard]] bool knows(std::uint32_t address, std::size_t length) const;
};

/// Learns the state of a bus from what a master read from it: each register as it was read first, and the
/// EEPROM word by word. Feed it every frame of a capture in order; what is no EtherCAT is passed over.
class BusRecorder {
 public:
  /// `frame` is decoded in place and not changed.
  void add(std::span<std::uint8_t> frame);
  /// By position. Made anew each time: a frame may claim thousands of slaves of which nothing is known.
  [[nodiscard]] std::vector<RecordedSlave> slaves() const;
  [[nodiscard]] std::size_t exchanges() const { return exchanges_; }

 private:
  struct Sent {
    DatagramHeader header;
    std::vector<std::uint8_t> data;
  };
  struct SentFrame {
    std::array<std::uint8_t, 6> source{};
    std::vector<Sent> datagrams;
  };
  /// What is known of one slave alone.
  struct Known {
    RecordedSlave slave;
    std::uint32_t sii_address = 0;  // that the master set last
    std::uint16_t sii_status = 0;
  };
  [[nodiscard]] std::optional<std::size_t> find_request(const SentFrame& frame) const;
  void learn(const Sent& sent, const Sent& returned, std::uint16_t wkc);
  void learn_broadcast(const Sent& sent, std::uint16_t wkc);
  void note_write(std::size_t position, std::uint16_t address, std::span<const std::uint8_t> data);
  void note_read(std::size_t position, std::uint16_t address, std::span<const std::uint8_t> data);
  static void note_sii(Known& from, std::uint16_t address, std::span<const std::uint8_t> data);
  void note_broadcast_write(std::uint16_t address, std::span<const std::uint8_t> data);
  Known& known(std::size_t position);
  [[nodiscard]] std::optional<std::size_t> position_of(const DatagramHeader& header) const;

  std::vector<SentFrame> open_;                    // sent and not yet back, oldest first
  std::size_t count_ = 0;                          // of the slaves
  std::map<std::size_t, Known> known_;             // by position
  std::map<std::uint16_t, std::size_t> stations_;  // station address to position
  std::uint32_t sii_address_of_all_ = 0;           // that the master has set by broadcast
  std::size_t exchanges_ = 0;
  std::shared_ptr<std::set<std::uint32_t>> written_to_all_ = std::make_shared<std::set<std::uint32_t>>();
};

}  // namespace syncline
