// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline {

struct MasterChannels;

/// The background core as those see it who look at it: its channels, and what makes its time pass. Who builds one knows
/// link, clock and threads (core/engine). Its end takes the slaves to INIT and waits for its thread.
class BackgroundMaster {
 public:
  virtual ~BackgroundMaster() = default;
  [[nodiscard]] virtual MasterChannels& channels() = 0;
  /// On a virtual clock time passes only as far as somebody lets it.
  [[nodiscard]] virtual bool is_virtual() const = 0;
  /// From here on a thread of its own carries out commands and runs the cycles; on a virtual clock at about the speed
  /// of real time.
  virtual void start() = 0;
  [[nodiscard]] virtual bool started() const = 0;
  /// Waits until the thread has ended; the bus stays as it is.
  virtual void stop() = 0;
  /// Unless started: one command, to its end, or one cycle in the calling thread. False when there was nothing to do.
  virtual bool step() = 0;
  /// Unless started, on a virtual clock: so much of the machine's time in the calling thread.
  virtual void run_for(Nanoseconds duration) = 0;
  /// A configuration runs. For the thread that calls step().
  [[nodiscard]] virtual bool online() const = 0;
};

}  // namespace syncline
