// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "support/result.h"

namespace syncline {
struct MailboxInitCmd;
struct RegisterCommand;
}  // namespace syncline

namespace syncline::settings {

/// "IP data=02000000 fixed off timeout=500 # comment": what follows the mailbox header, in wire order. As
/// format_startup() otherwise.
[[nodiscard]] std::string format_message(const MailboxInitCmd& message);
/// kBadValue with what is wrong in it; the subject stays empty.
[[nodiscard]] Result<MailboxInitCmd> parse_message(std::string_view text);

/// "PS write 0x09a8=0100 off # comment", "PS read 0x0130*2 expect=0400 mask=0f00 within=500 after # comment".
[[nodiscard]] std::string format_register(const RegisterCommand& command);
[[nodiscard]] Result<RegisterCommand> parse_register(std::string_view text);

}  // namespace syncline::settings
