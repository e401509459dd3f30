// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "protocol/al_state.h"
#include "protocol/coe.h"
#include "protocol/sdo_information.h"

namespace syncline {

/// What one may ask of one slave while the master is online, in whatever state the bus is: one struct a kind. `slave`
/// is the position in the configuration. What uses the mailbox needs a slave in PREOP or above (files: BOOT, too);
/// registers, EEPROM, states and acknowledging need none.
namespace requests {

/// SDO upload (ETG.1000.6, 5.6.2). Complete access begins at sub-index 0 or 1.
struct SdoRead {
  static constexpr std::uint32_t kMost = 16U << 20;
  std::uint16_t slave = 0;
  coe::ObjectAddress object;
  bool complete_access = false;
  std::uint32_t limit = 64U << 10;  // bytes; a larger object is refused. At most kMost
};
/// SDO download; expedited, normal or in segments as its length and the mailbox want it.
struct SdoWrite {
  std::uint16_t slave = 0;
  coe::ObjectAddress object;
  std::vector<std::uint8_t> data;
  bool complete_access = false;
};

/// The object dictionary (SDO information, ETG.1000.6, 5.6.3): which objects there are, one of them, an entry of one.
struct ObjectListRead {
  std::uint16_t slave = 0;
  coe::ObjectListType list = coe::ObjectListType::kAll;
};
struct ObjectRead {
  std::uint16_t slave = 0;
  std::uint16_t index = 0;
};
struct EntryRead {
  std::uint16_t slave = 0;
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::uint8_t value_info = 0;  // coe::value_info: what is wanted besides type, size, access and name
};

/// Registers and memory of the ESC, by station address. At most kMost bytes travel in one datagram; longer ranges are
/// read and written in several, one after the other.
struct RegisterRead {
  static constexpr std::size_t kMost = 512;
  std::uint16_t slave = 0;
  std::uint16_t address = 0;
  std::uint16_t length = 1;  // bytes
};
struct RegisterWrite {
  std::uint16_t slave = 0;
  std::uint16_t address = 0;
  std::vector<std::uint8_t> data;
};

/// Words of the EEPROM (ETG.1000.6, 5.4). It is taken from the slave's controller and given back.
struct EepromRead {
  std::uint16_t slave = 0;
  std::uint32_t word = 0;
  std::uint32_t words = 1;  // 1..65536
};
/// Happens as a whole or not at all: each word is read back, and when one fails those before it are put back. Words
/// that are right already are not written; the configuration area (words 0 to 7) comes last and must end up with its
/// checksum.
struct EepromWrite {
  std::uint16_t slave = 0;
  std::uint32_t word = 0;
  std::vector<std::uint8_t> data;  // two bytes a word, the low one first
};

/// FoE (ETG.1000.6, 5.8).
struct FileRead {
  static constexpr std::uint32_t kMost = 64U << 20;
  std::uint16_t slave = 0;
  std::string name;
  std::uint32_t password = 0;
  std::uint32_t limit = 1U << 20;  // bytes; a longer file is refused. At most kMost
};
struct FileWrite {
  std::uint16_t slave = 0;
  std::string name;
  std::uint32_t password = 0;
  std::vector<std::uint8_t> data;
};

/// Leads one slave to a state, step by step with its init commands, while the others stay where they are.
struct StateChange {
  std::uint16_t slave = 0;
  AlState state = AlState::kPreop;
};
/// Acknowledges the error that the slave's AL status shows.
struct ErrorAcknowledge {
  std::uint16_t slave = 0;
};

}  // namespace requests

using SlaveRequest = std::variant<requests::SdoRead, requests::SdoWrite, requests::ObjectListRead, requests::ObjectRead,
                                  requests::EntryRead, requests::RegisterRead, requests::RegisterWrite,
                                  requests::EepromRead, requests::EepromWrite, requests::FileRead, requests::FileWrite,
                                  requests::StateChange, requests::ErrorAcknowledge>;

[[nodiscard]] std::uint16_t slave_of(const SlaveRequest& request);
/// "object 0x6040:00", "register 0x0130", "file "fw.bin"": the thing of the slave that the request is about.
[[nodiscard]] std::string subject_of(const SlaveRequest& request);

}  // namespace syncline
