// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "config/sim_config.h"
#include "support/types.h"

namespace syncline::sim {

class EscMemory;

/// EEPROM behind registers 0x0500 to 0x050F (ESC data sheet II, 3.9): read, write, reload, each of which
/// keeps it busy for a while. Whoever owns it may give commands; writing needs the enable bit in the same frame.
class SiiInterface {
 public:
  SiiInterface(std::vector<std::uint8_t> content, const SimSiiConfig& config, EscMemory& memory);

  void implement_registers();
  /// The master must not write this register now: the EEPROM is busy or belongs to the PDI.
  [[nodiscard]] bool blocks(std::uint32_t address) const;
  /// A frame that wrote 0x0500 or 0x0501 is over.
  void configuration_written();
  /// A frame that wrote to 0x0502 or 0x0503 is over.
  void control_written(Nanoseconds time);
  /// Ends the command in work when it is due; true: the configuration data were loaded anew.
  [[nodiscard]] bool advance_to(Nanoseconds time);
  /// When that will be; the end of time: nothing is in work.
  [[nodiscard]] Nanoseconds due() const { return done_at_.value_or(INT64_MAX); }

  /// The first eight words are those that their checksum was made of.
  [[nodiscard]] bool checksum_ok() const;
  [[nodiscard]] const std::vector<std::uint8_t>& content() const { return content_; }

 private:
  void execute(std::uint16_t command);
  void read(std::uint32_t word);
  void load();
  void show(std::uint16_t flags);

  EscMemory& memory_;
  SimSiiConfig config_;
  std::vector<std::uint8_t> content_;
  std::uint16_t errors_ = 0;   // bits 11 to 14 of 0x0502
  std::uint16_t command_ = 0;  // in work
  std::optional<Nanoseconds> done_at_;
};

}  // namespace syncline::sim
