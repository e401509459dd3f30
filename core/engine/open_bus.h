// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "capture/capture_tap.h"
#include "capture/replay_link.h"
#include "engine/opened_link.h"
#include "master/exchange/bus.h"
#include "support/stop_signals.h"

namespace syncline {

/// Acyclic access to the slaves behind a link, for as long as it lives.
class OpenBus {
 public:
  /// `cancel` ends what runs on the bus; may be nullptr. `capture`: see capture_to(). Errors of `link`
  /// and as capture_to().
  [[nodiscard]] static Result<std::unique_ptr<OpenBus>> open(Result<OpenedLink> link,
                                                             const std::atomic<bool>* cancel = nullptr,
                                                             const std::string& capture = {});
  /// The same, for a slave that must be there. kNoResponse when it is not.
  [[nodiscard]] static Result<std::unique_ptr<OpenBus>> open_for_slave(Result<OpenedLink> link, std::uint16_t position,
                                                                       const std::atomic<bool>* cancel = nullptr);
  OpenBus(const OpenBus&) = delete;
  OpenBus& operator=(const OpenBus&) = delete;

  [[nodiscard]] Bus& bus() { return bus_; }
  /// What the capture that is replayed proves; null: a bus that lives.
  [[nodiscard]] const std::shared_ptr<const ReplayNotes>& replay() const { return opened_.replay; }
  /// How the capture fares, null without one; complete when this is gone.
  [[nodiscard]] const std::shared_ptr<const CaptureState>& capture() const { return capture_; }

 private:
  OpenBus(OpenedLink opened, std::shared_ptr<const CaptureState> capture, const std::atomic<bool>* cancel);

  std::shared_ptr<const CaptureState> capture_;
  std::optional<PauseRefused> driven_;  // on a real clock
  OpenedLink opened_;
  FrameExchange exchange_;
  Bus bus_;
};

}  // namespace syncline
