// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/mailbox_watch.h"

#include <algorithm>

#include "config/network_config.h"
#include "master/cyclic/mailbox_bits.h"
#include "master/exchange/mailbox_handshake.h"
#include "master/exchange/slave_mailbox.h"
#include "protocol/datagram.h"
#include "protocol/diagnosis_message.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline {
namespace {

namespace history = diagnosis_history;
/// Where a configuration has neither a bit nor a PollTime.
constexpr std::uint32_t kPollTimeMs = 50;
constexpr std::size_t kPollsPerCycle = 16;

}  // namespace

MailboxWatch::MailboxWatch(const NetworkConfig& config, std::span<SlaveMailbox> mailboxes, CyclicMailbox& mailbox,
                           const MailboxBits& bits)
    : mailboxes_(mailboxes), mailbox_(mailbox) {
  const auto& slaves = config.slaves;
  for (std::size_t i = 0; i < slaves.size(); ++i) {
    if (!slaves[i].mailbox) continue;
    Watched watched;
    watched.slave = static_cast<std::uint16_t>(i);
    watched.has_history = slaves[i].mailbox->coe;
    if (!bits.has(i))
      watched.poll_period = std::max(1U, slaves[i].mailbox->poll_time_ms.value_or(kPollTimeMs)) * kMillisecond;
    watched_.push_back(watched);
  }
  for (auto& watched : watched_) {
    watched.poll = {Command::kFprd, device_address(slaves[watched.slave].station_address, kSm1Status), watched.status};
  }
}

MailboxWatch::Watched* MailboxWatch::find(std::size_t slave) {
  const auto found = std::ranges::find(watched_, slave, &Watched::slave);
  return found == watched_.end() ? nullptr : &*found;
}

const MailboxWatch::Watched* MailboxWatch::find(std::size_t slave) const {
  const auto found = std::ranges::find(watched_, slave, &Watched::slave);
  return found == watched_.end() ? nullptr : &*found;
}

// ---- asking -------------------------------------------------------------------------------------

void MailboxWatch::add_to(PendingFrame& frame, Nanoseconds now) {
  polled_ = 0;
  if (watched_.empty()) return;
  add_polls(frame, now);
  schedule_history(now);
  if (mailbox_.idle()) begin();
}

/// In turn, so that a full frame only delays them.
void MailboxWatch::add_polls(PendingFrame& frame, Nanoseconds now) {
  polled_begin_ = next_poll_;
  auto place = polled_begin_;
  for (std::size_t n = 0; n < watched_.size() && polled_ < kPollsPerCycle; ++n) {
    auto& watched = watched_[place];
    place = behind(place);
    watched.poll.answered = false;
    const bool due =
        watched.poll_period > 0 && now >= watched.next_poll && !watched.full && mailbox_.ready_for(watched.slave);
    if (!due) continue;
    watched.status[0] = 0;
    if (!frame.add(watched.poll)) return;
    watched.next_poll = now + watched.poll_period;
    next_poll_ = place;
    ++polled_;
  }
}

void MailboxWatch::schedule_history(Nanoseconds now) {
  if (now < history_slot_) return;
  history_slot_ = now + kHistoryPeriod / static_cast<Nanoseconds>(watched_.size());
  next_history_ = (next_history_ + 1) % watched_.size();
  watched_[next_history_].history_due = true;
}

bool MailboxWatch::full(const Watched& slave) const {
  return slave.poll_period > 0 ? slave.full : mailboxes_[slave.slave].full.value_or(false);
}

void MailboxWatch::begin() {
  auto place = next_;
  for (std::size_t n = 0; n < watched_.size(); ++n, place = behind(place)) {
    auto& watched = watched_[place];
    const bool ask = watched.has_history && !watched.news && (watched.history_due || watched.newest_due);
    if ((!ask && !full(watched)) || !mailbox_.ready_for(watched.slave)) continue;
    next_ = behind(place);
    if (full(watched)) {
      watched.full = false;
      mailbox_.fetch(watched.slave);
    } else {
      mailbox_.upload(watched.slave, {history::kIndex, watched.newest_due ? history::kNewest : history::kNewAvailable});
      watched.history_due = watched.newest_due = false;
    }
    return;
  }
}

// ---- answers ------------------------------------------------------------------------------------

void MailboxWatch::take_polls() {
  if (polled_ == 0) return;
  for (auto& watched : watched_) {
    if (watched.poll.done() && (watched.status[0] & SyncManager::kStatusMailboxFull) != 0) watched.full = true;
    watched.poll.answered = false;
  }
}

void MailboxWatch::take(const CyclicMailbox::Answer& answer, Nanoseconds now) {
  using Kind = CyclicMailbox::Answer::Kind;
  auto* watched = find(answer.slave);
  if (watched == nullptr) return;
  if (answer.emergency) watched->history_due = true;
  // A slave may hold more than one message.
  if (answer.kind == Kind::kFetched) watched->next_poll = now;
  if (answer.object.index != history::kIndex) return;
  if (answer.kind == Kind::kAbort) watched->has_history = false;
  if (answer.kind != Kind::kValue) return;
  if (answer.object.sub_index == history::kNewAvailable) {
    // It stays set until somebody acknowledges: what was told already is known by its place.
    watched->newest_due = answer.value != 0;
  } else {
    watched->news = answer.value != watched->told;
  }
}

std::optional<std::size_t> MailboxWatch::news() const {
  const auto found = std::ranges::find(watched_, true, &Watched::news);
  return found == watched_.end() ? std::nullopt : std::optional<std::size_t>(found->slave);
}

std::uint8_t MailboxWatch::told(std::size_t slave) const {
  const auto* watched = find(slave);
  return watched == nullptr ? std::uint8_t{0} : watched->told;
}

void MailboxWatch::note_told(std::size_t slave, std::optional<std::uint8_t> newest) {
  auto* watched = find(slave);
  if (watched == nullptr) return;
  watched->news = false;
  if (newest) watched->told = *newest;
  if (!newest) watched->has_history = false;
}

}  // namespace syncline
