// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <thread>

namespace syncline {

class MasterService;

/// Runs a master on a virtual clock in a thread of its own, at about the speed of real time. However
/// late the host wakes this thread, the simulated machine does not notice: the demonstration stays in
/// sync on a busy desktop.
class VirtualPacer final {
 public:
  explicit VirtualPacer(MasterService& service);
  /// Waits until the present step has ended.
  ~VirtualPacer();
  VirtualPacer(const VirtualPacer&) = delete;
  VirtualPacer& operator=(const VirtualPacer&) = delete;

 private:
  void run() noexcept;
  void pace();

  MasterService& service_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace syncline
