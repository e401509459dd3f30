// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "channels/slave_evidence.h"

namespace syncline {

/// Requests in a row without an answer, of a mailbox that is told as silent: one and a few may be lost on their way.
inline constexpr std::uint32_t kMailboxSilentAfter = 5;

/// A mailbox that does not answer any more: what is read through it is not known.
[[nodiscard]] inline bool mailbox_silent(const SlaveEvidence& evidence) {
  return evidence.mailbox_silences >= kMailboxSilentAfter;
}

}  // namespace syncline
