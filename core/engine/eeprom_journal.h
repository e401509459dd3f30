// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "support/result.h"

namespace syncline {

/// What is being written into the EEPROM of a slave: on the disk from before the first word until the last one is
/// verified, or the old content is back. What a killed program leaves of it says how to finish.
struct EepromJournal {
  std::string link;  // LINK, as it was given
  std::uint16_t position = 0;
  std::string begun;                        // UTC, "2026-03-01 12:00:00"
  std::vector<std::uint8_t> before, after;  // of the same length
  bool operator==(const EepromJournal&) const = default;
};

/// $XDG_STATE_HOME/syncline/eeprom, or ~/.local/state/syncline/eeprom.
[[nodiscard]] std::string eeprom_journal_folder();
[[nodiscard]] Status keep_journal(const EepromJournal& journal);
void drop_journal(const std::string& link, std::uint16_t position);
[[nodiscard]] std::optional<EepromJournal> find_journal(const std::string& link, std::uint16_t position);
/// All that are there, by the names of their files; those that cannot be read are left out.
[[nodiscard]] std::vector<EepromJournal> pending_journals();

}  // namespace syncline
