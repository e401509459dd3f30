// SPDX-License-Identifier: Apache-2.0
#include "support/processor_wait.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstring>

namespace syncline {

std::optional<Nanoseconds> wait_of_schedstat(const char* line) {
  const char* const end = line + std::strlen(line);
  Nanoseconds ran = 0, waited = 0;
  const auto first = std::from_chars(line, end, ran);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != ' ') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, waited);
  return second.ec == std::errc() && waited >= 0 ? std::optional(waited) : std::nullopt;
}

ProcessorWait::~ProcessorWait() {
  if (file_ >= 0) ::close(file_);
}

std::optional<Nanoseconds> ProcessorWait::take() {
  if (refused_) return std::nullopt;
  if (file_ < 0) file_ = ::open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC);
  std::array<char, 80> line{};
  const auto length = file_ < 0 ? -1 : ::pread(file_, line.data(), line.size() - 1, 0);
  if (length > 0) return wait_of_schedstat(line.data());
  refused_ = true;
  return std::nullopt;
}

}  // namespace syncline
