// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <exception>
#include <optional>
#include <thread>

#include "channels/event.h"
#include "channels/master_channels.h"
#include "master/exchange/bus.h"
#include "master/master_service.h"
#include "support/real_time.h"
#include "support/stop_signals.h"

namespace syncline {
struct MasterThread::Impl {
  explicit Impl(MasterService& own_service) : service(own_service) {
    if (!service.clock().is_virtual()) driven.emplace();
    const StopSignalsBlocked deaf;  // whoever started the thread hears them
    thread = std::thread([this] { run(); });
  }

  /// Without memory for it the bus is driven without priority, or nobody is told: no reason to end.
  void enter_real_time(std::optional<RealTimeScope>& real_time) noexcept {
    try {
      real_time.emplace();
      if (real_time->refused().empty()) return;
      service.channels().events.push({service.clock().now(), -1, events::RealTimeRefused{real_time->refused()}});
    } catch (const std::exception&) {
      return;
    }
  }

  void run() {
    auto& clock = service.clock();
    // Virtual time has no deadlines, and a thread that never sleeps must not have priority.
    std::optional<RealTimeScope> real_time;
    if (!clock.is_virtual()) enter_real_time(real_time);
    while (!stop.load(std::memory_order_relaxed)) {
      if (!service.step_guarded()) clock.sleep_until(clock.now() + kIdlePeriod);
    }
    service.shut_down();
  }

  MasterService& service;
  std::optional<PauseRefused> driven;
  std::atomic<bool> stop{false};
  std::thread thread;
};

MasterThread::MasterThread(MasterService& service) : impl_(std::make_unique<Impl>(service)) {}
MasterThread::~MasterThread() { stop(); }

void MasterThread::stop() {
  if (!impl_->thread.joinable()) return;
  impl_->stop = true;
  impl_->service.channels().cancel = true;  // a bring-up or a scan under way ends
  impl_->thread.join();
  impl_->driven.reset();
}

}  // namespace syncline
