// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "link/link.h"

/// What a running cycle may not do, counted in the thread that asks: this binary's malloc and kin and its operator new
/// stand in front of the library's, and so do the functions that take a lock.
namespace syncline::test {

struct CycleCounts {
  std::size_t allocations = 0;
  std::size_t locks = 0;  // mutexes, read-write locks, waits on conditions and semaphores
};

/// Counts in this thread while it lives.
class CountingCycle {
 public:
  explicit CountingCycle(CycleCounts& counts);
  ~CountingCycle();
  CountingCycle(const CountingCycle&) = delete;
  CountingCycle& operator=(const CountingCycle&) = delete;

 private:
  CycleCounts* before_;
};

/// The bus of a test allocates; that is not the master's doing.
class UncountedLink final : public Link {
 public:
  explicit UncountedLink(Link& inner) : inner_(inner) {}
  explicit UncountedLink(std::unique_ptr<Link> inner) : own_(std::move(inner)), inner_(*own_) {}
  Status send(std::span<const std::uint8_t> frame) override;
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override;
  [[nodiscard]] LinkDescription describe() const override { return inner_.describe(); }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return inner_.sent_at(); }
  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override;

 private:
  std::unique_ptr<Link> own_;
  Link& inner_;
};

}  // namespace syncline::test
