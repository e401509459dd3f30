// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "support/types.h"
#include "trace/dcm_log.h"

namespace syncline {

struct CycleSample;
struct NetworkConfig;
struct Snapshot;

/// The log of the master synchronisation of a run while it goes on, once for both programs: what of the run it is made
/// with, and which of what is drained goes into it. Where the text goes is its owner's matter. For the thread that
/// drains.
class DcmLogSession {
 public:
  using Write = std::function<void(std::string_view)>;
  /// Begins with the header.
  DcmLogSession(const NetworkConfig& config, Write write);

  /// A run of that configuration goes on in this log: set value and cycle time are the same in all of one.
  [[nodiscard]] bool suits(const NetworkConfig& config) const;
  void add(std::span<const CycleSample> samples);
  void add(const Snapshot& snapshot);

 private:
  Nanoseconds set_value_, cycle_time_;
  DcmLog log_;
  Write write_;
  std::string text_;
};

}  // namespace syncline
