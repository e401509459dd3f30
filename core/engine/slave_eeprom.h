// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "engine/opened_link.h"
#include "support/result.h"

namespace syncline {

struct SiiWriteReport;

/// The EEPROM of the slave at `position` behind a LINK. Each call opens and closes the link. kNoResponse when
/// there is no such slave, kSii with the slave in its subject, file errors.
struct EepromRequest {
  std::string link;
  std::uint16_t position = 0;
  std::function<Result<OpenedLink>(const std::string& link)> open{};  // never empty
  const std::atomic<bool>* cancel = nullptr;
};

/// Copies the EEPROM into a file, complete or not at all; returns its bytes.
[[nodiscard]] Result<std::size_t> save_eeprom(const EepromRequest& request, const std::string& path);
/// Makes the EEPROM hold the file's bytes, see write_eeprom(). Before the first word a journal is kept, which goes when
/// all is written or put back; one that a killed program has left keeps what the EEPROM held before that program.
[[nodiscard]] Result<SiiWriteReport> load_eeprom(const EepromRequest& request, const std::string& path);
[[nodiscard]] Result<SiiWriteReport> set_eeprom_alias(const EepromRequest& request, std::uint16_t alias);

/// Ends what a killed program began, by its journal: what it wanted to write, or with `undo` what was there before. The
/// EEPROM must hold a mixture of the two, but for the one word that was being written: else it is another slave's, or
/// somebody else has written since. kBadValue without a journal for that slave.
[[nodiscard]] Result<SiiWriteReport> finish_eeprom(const EepromRequest& request, bool undo);

}  // namespace syncline
