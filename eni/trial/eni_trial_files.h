// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {
class TrialFiles;
}  // namespace syncline

namespace syncline::eni {

/// ESI and ENI files for trials of devices (core/engine/try_esi.h); lives as long as the program.
[[nodiscard]] const TrialFiles& trial_files();

}  // namespace syncline::eni
