// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "config/identity.h"

namespace syncline {

struct DeviceDescription;
class TrialFiles;

enum class TryOutcome : std::uint8_t { kPassed, kExcepted, kFailed };
/// What was done with a device when it did not pass; kDone when it did.
enum class TryStep : std::uint8_t { kRead, kCompile, kExport, kCheck, kRun, kDone };

[[nodiscard]] std::string_view outcome_name(TryOutcome outcome);  // "passed", "excepted", "failed"
[[nodiscard]] std::string_view step_name(TryStep step);           // "read", "compile", "export", "check", "run", "done"

/// One device of an ESI file, tried on its own.
struct TriedDevice {
  std::string file;
  int line = 0;  // where a device that cannot be read is wrong
  Identity identity{};
  std::string type{}, name{};
  TryOutcome outcome = TryOutcome::kPassed;
  TryStep step = TryStep::kDone;
  std::string reason{};            // of an exception or a failure
  std::uint32_t modules = 0;       // plugged
  std::uint16_t wkc_expected = 0;  // sum over the cyclic commands in OP
  std::uint64_t cycles = 0;        // in OP, all with that working counter
  bool operator==(const TriedDevice&) const = default;
};

/// Makes a project with the ESI's defaults of the one device, compiles it, writes its ENI, checks it, reads it again
/// and runs what was read on the simulated device of the same description, on the virtual clock, until it has been in
/// OP for some cycles. `keep`: file for the ENI; "" = none. Bounded in time. Any thread.
[[nodiscard]] TriedDevice try_device(const DeviceDescription& device, const TrialFiles& files,
                                     const std::string& keep = {});

}  // namespace syncline
