// SPDX-License-Identifier: Apache-2.0
#include "engine/virtual_pacer.h"

#include <algorithm>
#include <chrono>
#include <exception>

#include "master/master_service.h"

namespace syncline {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kInterval{10};
/// After a long stop (a suspended host) the machine goes on from where it was.
constexpr std::chrono::milliseconds kCatchUp{100};

}  // namespace

VirtualPacer::VirtualPacer(MasterService& service) : service_(service), thread_([this] { run(); }) {}

VirtualPacer::~VirtualPacer() {
  stop_ = true;
  thread_.join();
}

void VirtualPacer::run() noexcept {
  try {
    pace();
  } catch (const std::exception&) {
    service_.shut_down();  // told by the bus going offline, as where a master's own thread ends
  }
}

void VirtualPacer::pace() {
  auto last = SteadyClock::now();
  while (!stop_) {
    const auto now = SteadyClock::now();
    const auto due = std::min<SteadyClock::duration>(now - last, kCatchUp);
    last = now;
    service_.run_for(std::chrono::duration_cast<std::chrono::nanoseconds>(due).count());
    std::this_thread::sleep_for(kInterval);
  }
}

}  // namespace syncline
