// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "master/channels.h"

namespace syncline::diagnosis {

/// Which cause has most of the missed SM2 events.
[[nodiscard]] dc::MissCause main_cause(const Sm2MissedStatus& status);
/// "frames were lost": goes behind a colon or "because".
[[nodiscard]] std::string_view miss_cause_words(dc::MissCause cause);

}  // namespace syncline::diagnosis
