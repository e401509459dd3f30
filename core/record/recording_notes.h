// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "support/result.h"

namespace syncline {

struct RunNote;

/// The notes of a recording that nobody writes any more, in place of those that it has; nothing else of it changes, and
/// it has all of them or those from before. kFileNotWritable, also while another program writes it; the errors of
/// open_recording().
[[nodiscard]] Status write_notes(const std::string& path, std::span<const RunNote> notes);

}  // namespace syncline
