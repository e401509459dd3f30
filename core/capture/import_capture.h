// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "record/import_run.h"
#include "support/result.h"

namespace syncline {

/// Told every few thousand frames: bytes that are read, and those of the whole file (0: not known); false ends it.
using ImportProgress = std::function<bool(std::uint64_t done, std::uint64_t all)>;
struct ImportedRun;

/// The run that a capture (pcap, pcapng) of any master shows: a cycle begins with each frame of the process-data
/// command that came most often (without any, of the reading of the reference clock). Told are the times of the frames,
/// by a probe's own stamps (ET2000) where it has them, else by the host's; whether they came back, and their working
/// counters; the system time of the reference clock (0x0910); deviations (0x092C), or-ed and of single slaves, which
/// have the order of their station addresses. Which working counter is right, verdicts, states and errors of a
/// controller no capture tells.
///
/// `limits` says which part of the file is read: other frames count for nothing.
///
/// A capture that breaks off is imported up to there, which is a finding, and so are frames that were captured in part.
/// As PcapReader where not a single frame can be read; kBadValue where no cyclic frame came back,
/// or none lies in the part that `limits` names;
/// kCancelled where `progress` ended it.
[[nodiscard]] Result<ImportedRun> import_capture(const std::string& path, const ImportLimits& limits = {},
                                                 const ImportProgress& progress = {});

}  // namespace syncline
