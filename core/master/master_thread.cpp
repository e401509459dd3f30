// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <thread>

#include "master/master_service.h"

namespace syncline {
namespace {

constexpr int kPriority = 80;  // above threaded interrupts, below the kernel's own
constexpr std::size_t kStackPrefault = 256 * 1024;
constexpr Nanoseconds kIdlePeriod = 1 * kMillisecond;

std::string refusal(const char* what, int error) { return fmt::format("{} ({})", what, std::strerror(error)); }

/// Touches the stack that the cycle will use, so that no page fault comes later.
void prefault_stack() {
  std::array<volatile std::uint8_t, kStackPrefault> area;
  for (std::size_t i = 0; i < area.size(); i += 4096) area[i] = 0;
}

/// What the system does not permit, in words; empty when all was granted.
std::string enter_real_time() {
  std::string refused;
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) refused = refusal("memory is not locked", errno);
  sched_param parameter{};
  parameter.sched_priority = kPriority;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter); error != 0) {
    if (!refused.empty()) refused += ", ";
    refused += refusal("SCHED_FIFO is not permitted", error);
  }
  prefault_stack();
  return refused;
}

}  // namespace

struct MasterThread::Impl {
  explicit Impl(MasterService& own_service) : service(own_service), thread([this] { run(); }) {}

  void run() {
    auto& clock = service.clock();
    // Virtual time has no deadlines, and a thread that never sleeps must not have priority.
    auto refused = clock.is_virtual() ? std::string() : enter_real_time();
    if (!refused.empty()) {
      Event event;
      event.kind = EventKind::kRealTime;
      event.time = clock.now();
      event.text = std::move(refused);
      service.channels().events.push(std::move(event));
    }
    while (!stop.load(std::memory_order_relaxed)) {
      if (!service.step()) clock.sleep_until(clock.now() + kIdlePeriod);
    }
  }

  MasterService& service;
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
}

}  // namespace syncline
