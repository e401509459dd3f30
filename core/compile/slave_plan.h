// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "config/device_description.h"
#include "config/slave_config.h"
#include "config/slave_settings.h"
#include "protocol/fmmu.h"
#include "support/types.h"

namespace syncline {
struct SyncManager;
}  // namespace syncline

/// Values that the steps of compile() hand to each other. Each step fills its own part and leaves the rest.
namespace syncline::compiler {

/// A SyncManager that carries process data.
struct ProcessDataChannel {
  std::uint8_t number = 0;
  SyncManagerDescription description;
  std::vector<std::uint16_t> pdos;  // assigned, in order
  std::uint32_t bit_length = 0;     // sum of the PDOs

  /// Registers that are process data, e.g. latched times: an FMMU maps them, no SyncManager guards them.
  [[nodiscard]] bool is_virtual() const { return description.is_virtual; }
  [[nodiscard]] bool is_output() const { return description.type == SyncManagerType::kOutputs; }
  [[nodiscard]] std::uint16_t byte_length() const { return static_cast<std::uint16_t>((bit_length + 7) / 8); }
  /// Register image; inactive when the channel carries nothing.
  [[nodiscard]] SyncManager image() const;
};

/// The mailbox pair of SyncManagers.
struct MailboxPlan {
  std::uint8_t out_number = 0, in_number = 1;
  std::uint8_t out_control = 0, in_control = 0;
  MailboxChannel out, in;
  std::optional<MailboxChannel> bootstrap_out, bootstrap_in;
  bool uses_status_bit = false;
  std::uint32_t status_bit = 0;  // running number over the bus, when uses_status_bit
};

struct FmmuPlan {
  FmmuUse use = FmmuUse::kUnused;
  Fmmu image;
};

/// Where one direction of a slave lies in the logical address space.
struct Placement {
  std::uint32_t bits = 0;             // 0: this direction has no data
  std::uint32_t logical_address = 0;  // byte
  std::uint8_t start_bit = 0;         // inside that byte; not 0 only for bit-packed slaves
  std::size_t datagram = 0;           // index in ImageLayout::datagrams
  bool operator==(const Placement&) const = default;
};

struct SlavePlan {
  /// As effective_slave() gives it: what the user sets against the ESI is in the description.
  const SlaveSettings* settings = nullptr;
  std::shared_ptr<const SlaveSettings> effective;  // keeps a changed one; null when `settings` is the project's own
  std::uint16_t position = 0;
  std::vector<ConfiguredPdo> pdos;           // every PDO: Tx, then Rx; sync_manager set on assigned ones only
  std::vector<ProcessDataChannel> channels;  // SyncManager order
  std::optional<MailboxPlan> mailbox;
  std::optional<SlaveDcConfig> dc;
  /// Digital terminals without mailbox whose entries are all smaller than a byte are mapped bit by bit.
  bool bit_oriented = false;
  /// Sync Units of the two directions: 0 is the unnamed one, 1.. those of MasterSettings::sync_units.
  std::size_t output_unit = 0, input_unit = 0;
  /// Of the fastest task that exchanges its process data, ns: the Sync Unit Cycle.
  Nanoseconds cycle_time = kMillisecond;
  Placement outputs, inputs;
  std::vector<FmmuPlan> fmmus;  // index = FMMU number

  [[nodiscard]] const DeviceDescription& device() const { return settings->device; }
  [[nodiscard]] bool dc_commands() const { return dc && dc->assign_activate != 0; }
  /// Bits of one direction in the process image: exact for bit-oriented slaves, else whole bytes a channel.
  [[nodiscard]] std::uint32_t image_bits(PdoDirection direction) const;
  [[nodiscard]] const Pdo* find_pdo(std::uint16_t index) const;
};

}  // namespace syncline::compiler
