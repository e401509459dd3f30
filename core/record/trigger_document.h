// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "record/recording.h"
#include "trace/kept_trigger.h"

namespace syncline {

/// Triggers and their episodes as a document of a recording, of the kind "triggers": a line each, fields by tabulators
/// (docs/recording.md).
[[nodiscard]] RecordedDocument trigger_document(std::span<const KeptTrigger> kept);
/// Those of a recording. Lines that are not as they are written are passed over, with the episodes of such a trigger.
[[nodiscard]] std::vector<KeptTrigger> kept_triggers(const RecordingAbout& about);

}  // namespace syncline
