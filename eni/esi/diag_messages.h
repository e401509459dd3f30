// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "eni/esi/esi_reader.h"
#include "support/result.h"

namespace syncline {
struct Identity;
}  // namespace syncline

namespace syncline::eni {

/// Profile/DiagMessages/DiagMessage (ETG.2000): what a message of the diagnosis history (0x10F3) says.
struct DiagMessageText {
  std::uint16_t text_id = 0;
  std::string text{};         // MessageText; C conversions (%d ...) take the message's parameters
  std::string description{};  // what is behind it; may be empty
  bool operator==(const DiagMessageText&) const = default;
};

/// Those of the device of that identity and of the modules in the same file, and of the files that they name
/// (DiagFile); where a text id comes again, its first text holds. A device may have thousands and nobody needs them for
/// its configuration: they are read when somebody looks at a history and are no part of a project. Errors of the file
/// as read_esi(); kUnknownDevice when the device is not in it. A message that cannot be read is left out.
[[nodiscard]] Result<std::vector<DiagMessageText>> read_diag_messages(const std::string& esi_path,
                                                                      const Identity& identity,
                                                                      const EsiReadOptions& options = {});
/// The same from text, without other files.
[[nodiscard]] Result<std::vector<DiagMessageText>> parse_diag_messages(std::string_view text,
                                                                       const std::string& file_name,
                                                                       const Identity& identity,
                                                                       const EsiReadOptions& options = {});

/// Null when there is none.
[[nodiscard]] const DiagMessageText* find_text(const std::vector<DiagMessageText>& texts, std::uint16_t text_id);

}  // namespace syncline::eni
