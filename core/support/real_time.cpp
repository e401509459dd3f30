// SPDX-License-Identifier: Apache-2.0
#include "support/real_time.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace syncline {
namespace {

constexpr std::size_t kStackPrefault = 256 * 1024;

/// Touches the stack that the thread will use, so that no page fault comes later.
void prefault_stack() {
  std::array<volatile std::uint8_t, kStackPrefault> area;
  for (std::size_t i = 0; i < area.size(); i += 4096) area[i] = 0;
}

/// Allows the processor no wake-up latency while the descriptor is open (Linux PM QoS); -1 when refused.
int forbid_deep_sleep() {
  const int fd = ::open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC);
  if (fd < 0) return -1;
  const std::int32_t latency_us = 0;
  if (::write(fd, &latency_us, sizeof(latency_us)) == sizeof(latency_us)) return fd;
  ::close(fd);
  return -1;
}

}  // namespace

RealTimeScope::RealTimeScope(int priority) {
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) != 0) note("memory is not locked", errno);
  sched_param parameter{};
  parameter.sched_priority = priority;
  if (const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameter); error != 0) {
    note("SCHED_FIFO is not permitted", error);
  }
  // Not told when it fails: machines without the device have no deep sleep to forbid.
  latency_fd_ = forbid_deep_sleep();
  prefault_stack();
}

RealTimeScope::~RealTimeScope() {
  give_up_real_time();
  if (latency_fd_ >= 0) ::close(latency_fd_);
}

int real_time_priority() {
  sched_param parameter{};
  int policy = SCHED_OTHER;
  if (::pthread_getschedparam(::pthread_self(), &policy, &parameter) != 0) return 0;
  return policy == SCHED_FIFO || policy == SCHED_RR ? parameter.sched_priority : 0;
}

void give_up_real_time() {
  const sched_param parameter{};
  (void)::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &parameter);
}

std::string bind_to_processor(unsigned cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  int error = EINVAL;
  if (cpu < CPU_SETSIZE) {
    CPU_SET(cpu, &set);
    error = ::pthread_setaffinity_np(::pthread_self(), sizeof(set), &set);
  }
  return error == 0 ? std::string() : fmt::format("not bound to processor {} ({})", cpu, std::strerror(error));
}

void RealTimeScope::note(const char* what, int error) {
  if (!refused_.empty()) refused_ += ", ";
  refused_ += fmt::format("{} ({})", what, std::strerror(error));
}

}  // namespace syncline
