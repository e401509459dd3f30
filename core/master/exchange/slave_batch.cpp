// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/slave_batch.h"

#include <algorithm>
#include <vector>

#include "master/exchange/bus.h"

namespace syncline {
namespace {

/// Takes over what came back into the datagram that a work looks at.
void hand_back(const Datagram& from, Datagram& to) {
  to.wkc = from.wkc;
  to.answered = from.answered;
  to.times_sent = from.times_sent;
}

/// Nobody has a datagram: with bus cycles until the next one, else a millisecond, or less where all know when they
/// will.
Status pause(Bus& bus, std::span<SlaveWork* const> works, Nanoseconds now) {
  const auto due = std::ranges::min(works, {}, &SlaveWork::not_before)->not_before();
  if (bus.cyclic() || due <= now) return bus.wait_a_little();
  return bus.wait(std::min(due - now, kMillisecond));
}

}  // namespace

Status run_side_by_side(Bus& bus, std::span<SlaveWork* const> works) {
  std::vector<SlaveWork*> open(works.begin(), works.end());
  std::vector<SlaveWork*> asking;
  std::vector<Datagram*> asked;
  std::vector<Datagram> round;
  while (true) {
    asking.clear();
    asked.clear();
    round.clear();
    const auto now = bus.clock().now();
    for (auto* work : open) {
      auto* datagram = work->next(now);
      if (datagram == nullptr) continue;
      asking.push_back(work);
      asked.push_back(datagram);
      round.push_back(*datagram);
    }
    std::erase_if(open, [](const SlaveWork* work) { return work->over(); });
    if (open.empty()) return {};
    if (round.empty()) {
      if (auto status = pause(bus, open, now); !status) return status;
      continue;
    }
    if (auto status = bus.transact(round); !status) return status;
    const auto back = bus.clock().now();
    for (std::size_t i = 0; i < asking.size(); ++i) {
      hand_back(round[i], *asked[i]);
      asking[i]->take(back);
    }
    // With bus cycles the exchange itself took one.
    const auto patient = [](const SlaveWork* work) { return !work->over() && !work->in_a_hurry(); };
    if (bus.cyclic() || !std::ranges::all_of(asking, patient)) continue;
    if (auto status = bus.wait_a_little(); !status) return status;
  }
}

Status run_to_end(Bus& bus, SlaveWork& work) {
  SlaveWork* const works[] = {&work};
  if (auto status = run_side_by_side(bus, works); !status) return status;
  return work.result();
}

}  // namespace syncline
