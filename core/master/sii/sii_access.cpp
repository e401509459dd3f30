// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_access.h"

#include <algorithm>

#include "master/exchange/bus.h"
#include "master/sii/sii_layout.h"
#include "protocol/registers.h"
#include "reasons/brief_reason.h"

namespace syncline {
namespace {

/// An I2C EEPROM at 150 kHz gives eight bytes in 0.7 ms; a slave whose PDI emulates it may need far longer.
constexpr Nanoseconds kFirstPause = 1 * kMillisecond;
constexpr Nanoseconds kShortestPause = 20 * kMicrosecond;
constexpr int kSureReads = 3;  // before a shorter pause is tried
/// Looks that are so close to each other go into one frame.
constexpr Nanoseconds kTogether = 100 * kMicrosecond;
constexpr int kSiiTries = 4;
/// One command for everybody pays from here on.
constexpr std::size_t kFewestForBroadcast = 3;

void store_command(std::span<std::uint8_t> bytes, std::uint16_t command, std::uint32_t word) {
  store_le(bytes, command);
  store_le(bytes.subspan(2), word);
}

}  // namespace

/// A request under way.
struct SiiAccess::Job {
  SiiRequest* request = nullptr;
  std::size_t got = 0;  // bytes that are in the request
  bool started = false;
  bool failed_command = false;  // errors must be cleared before the next try
  Nanoseconds start_time = 0, next_look = 0;
  std::optional<Nanoseconds> busy_for;  // at the latest look, since the start
  int silences = 0, errors = 0, mismatches = 0;
  std::array<std::uint8_t, kWindowBytes> window{};

  [[nodiscard]] std::uint32_t word() const { return request->word + static_cast<std::uint32_t>(got / 2); }
  [[nodiscard]] bool open() const { return got < 8 && !request->error; }
  void give_up(BriefRow<1> why) {
    request->error = Error{ErrorCode::kSii, "slave", brief(why, hex_number(word(), 4)).in_full()};
  }
};

SiiAccess::SiiAccess(Bus& bus, std::vector<SlaveAddress> slaves, Options options)
    : bus_(bus), slaves_(std::move(slaves)), ports_(slaves_.size()), options_(options) {
  for (auto& port : ports_) port.pace = kFirstPause;
}

Status SiiAccess::look() {
  std::vector<std::array<std::uint8_t, kLookBytes>> bytes(size());
  std::vector<Datagram> datagrams;
  for (std::size_t i = 0; i < size(); ++i) datagrams.push_back(slaves_[i].read(reg::kSiiConfiguration, bytes[i]));
  if (auto status = bus_.transact(datagrams); !status) return status;
  for (std::size_t i = 0; i < size(); ++i) set_found(i, bytes[i]);
  return {};
}

void SiiAccess::set_found(std::size_t slave, std::span<const std::uint8_t, kLookBytes> bytes) {
  const auto control = load_le<std::uint16_t>(bytes.subspan(2));
  auto& port = ports_[slave];
  port.pdi = ((bytes[0] | bytes[1]) & 0x01) != 0;
  port.old_error = (control & (kSiiCommandError | kSiiWriteEnableError)) != 0;
  port.eight_bytes = (control & kSiiReadsEightBytes) != 0;
  port.looked_at = true;
}

Status SiiAccess::open() {
  if (!std::ranges::all_of(ports_, &Port::looked_at)) {
    if (auto status = look(); !status) return status;
  }
  std::vector<std::size_t> to_take, to_clear;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!accessible(i)) continue;
    if (ports_[i].pdi) to_take.push_back(i);
    if (ports_[i].old_error) to_clear.push_back(i);
  }
  const auto write_all = [&](std::span<const std::size_t> whom, std::uint16_t ado, std::vector<std::uint8_t> value) {
    std::vector<Datagram> writes;
    for (const auto i : whom) writes.push_back(slaves_[i].write(ado, value));
    return bus_.transact(writes);
  };
  // Force, then assign to ECAT: two frames, for a register takes one value a frame.
  if (auto status = write_all(to_take, reg::kSiiConfiguration, {0x02}); !status) return status;
  if (auto status = write_all(to_take, reg::kSiiConfiguration, {0x00}); !status) return status;
  return write_all(to_clear, reg::kSiiControl, {0x00, 0x00});
}

Status SiiAccess::close() {
  std::array<std::uint8_t, 1> to_pdi{0x01};
  std::vector<Datagram> writes;
  for (std::size_t i = 0; i < size(); ++i) {
    if (ports_[i].pdi && accessible(i)) writes.push_back(slaves_[i].write(reg::kSiiConfiguration, to_pdi));
  }
  // Also when the user wants an end: nobody else would give them back.
  const NotCancellable to_the_end(bus_);
  return bus_.transact(writes);
}

Status SiiAccess::read(std::span<SiiRequest> requests, std::optional<std::uint32_t> next) {
  std::vector<Job> jobs;
  for (auto& request : requests) {
    auto& port = ports_[request.slave];
    auto& job = jobs.emplace_back();
    job.request = &request;
    request.error.reset();
    job.started = port.started == request.word;
    job.start_time = bus_.clock().now();
    job.next_look = job.start_time + port.pace;
    port.started.reset();
  }
  // What begins before this read has ended could take the place of a read that is not fetched yet: with all of them
  // only where no look came too early lately; later with those whom the others wait for.
  bool look_ahead = calm_;
  calm_ = true;
  while (!jobs.empty()) {
    if (auto status = clear_errors(jobs); !status) return status;
    if (auto status = start(jobs); !status) return status;
    if (!probed_) {
      if (auto status = probe(jobs.front()); !status) return status;
      for (auto& job : jobs) job.next_look = bus_.clock().now();
    }
    const auto due = std::ranges::min(jobs, {}, &Job::next_look).next_look;
    if (const auto left = due - bus_.clock().now(); left > 0) {
      if (auto status = bus_.wait(left); !status) return status;
    }
    if (auto status = fetch(requests, jobs, look_ahead ? next : std::nullopt); !status) return status;
    look_ahead = jobs.size() < requests.size();
  }
  return {};
}

/// How long EEPROMs here take is found by one of them, with one datagram a look, before all are looked at.
Status SiiAccess::probe(const Job& job) {
  Nanoseconds pace = kFirstPause, too_early = 0;
  for (;; pace *= 2) {
    if (auto status = bus_.wait(std::max<Nanoseconds>(job.start_time + pace - bus_.clock().now(), 1)); !status)
      return status;
    std::array<std::uint8_t, 2> control{};
    auto read = slaves_[job.request->slave].read(reg::kSiiControl, control);
    if (auto status = bus_.transact(read); !status) return status;
    if (read.wkc == 0 || (load_le<std::uint16_t>(control) & kSiiBusy) == 0 || pace > kSiiBusyLimit) break;
    too_early = pace;
  }
  probed_ = true;
  for (auto& port : ports_) {
    port.pace = pace;
    port.too_early = too_early;
  }
  return {};
}

Status SiiAccess::clear_errors(std::vector<Job>& jobs) {
  std::array<std::uint8_t, 2> zero{};
  std::vector<Datagram> writes;
  for (auto& job : jobs) {
    if (!job.failed_command) continue;
    writes.push_back(slaves_[job.request->slave].write(reg::kSiiControl, zero));
    job.failed_command = false;
  }
  return bus_.transact(writes);
}

Status SiiAccess::start(std::vector<Job>& jobs) {
  std::vector<Job*> to_start;
  for (auto& job : jobs) {
    if (!job.started) to_start.push_back(&job);
  }
  if (to_start.empty()) return {};
  const bool same = std::ranges::all_of(to_start, [&](const auto* job) { return job->word() == to_start[0]->word(); });
  std::vector<Datagram> writes;
  if (options_.broadcast && same && to_start.size() == jobs.size() && jobs.size() >= kFewestForBroadcast) {
    store_command(to_start[0]->window, kSiiReadCommand, to_start[0]->word());
    writes.push_back(
        {Command::kBwr, device_address(0, reg::kSiiControl), std::span(to_start[0]->window).first(kSiiStatusBytes)});
    // Whatever the others were doing, they do this now.
    for (auto& port : ports_) port.started.reset();
  } else {
    for (auto* job : to_start) {
      store_command(job->window, kSiiReadCommand, job->word());
      writes.push_back(
          slaves_[job->request->slave].write(reg::kSiiControl, std::span(job->window).first(kSiiStatusBytes)));
    }
  }
  if (auto status = bus_.transact(writes); !status) return status;
  for (auto* job : to_start) {
    job->started = true;
    job->start_time = bus_.clock().now();
    job->next_look = job->start_time + ports_[job->request->slave].pace;
    job->busy_for.reset();
  }
  return {};
}

bool SiiAccess::may_look_ahead(std::span<const SiiRequest> requests, const std::vector<Job>& jobs) const {
  return options_.broadcast && requests.size() >= kFewestForBroadcast &&
         std::ranges::all_of(requests,
                             [this](const SiiRequest& request) {
                               const auto& port = ports_[request.slave];
                               return port.eight_bytes && port.reads_address_back;
                             }) &&
         std::ranges::all_of(jobs, [](const Job& job) { return job.got == 0 && job.mismatches == 0; });
}

Status SiiAccess::fetch(std::span<const SiiRequest> requests, std::vector<Job>& jobs,
                        std::optional<std::uint32_t> next) {
  std::vector<Datagram> datagrams;
  std::vector<Job*> asked;
  const auto latest = bus_.clock().now() + kTogether;
  for (auto& job : jobs) {
    if (job.next_look > latest) continue;
    job.window.fill(0);
    asked.push_back(&job);
    datagrams.push_back(slaves_[job.request->slave].read(reg::kSiiControl, job.window));
  }
  // The next read begins behind the last answer. A slave that is still busy ignores it (write access is
  // blocked), and a slave that takes it too early shows the wrong address and is asked again.
  std::array<std::uint8_t, kSiiStatusBytes> ahead{};
  const bool look_ahead = next && asked.size() == jobs.size() && may_look_ahead(requests, jobs);
  if (look_ahead) {
    store_command(ahead, kSiiReadCommand, *next);
    datagrams.push_back({Command::kBwr, device_address(0, reg::kSiiControl), ahead});
  }
  if (auto status = bus_.transact(datagrams); !status) return status;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    auto& job = *asked[i];
    if (datagrams[i].wkc == 0) {
      if (++job.silences == kSiiTries) job.give_up("no answer at word 0x{word}{which}");
      job.next_look = bus_.clock().now() + kFirstPause;
      continue;
    }
    if (take(job, look_ahead)) {
      learn(job);
    } else {
      calm_ = false;
    }
  }
  if (look_ahead) {
    for (const auto& request : requests) {
      if (!request.error) ports_[request.slave].started = next;
    }
    for (const auto& job : jobs) {
      if (job.open()) ports_[job.request->slave].started.reset();
    }
  }
  std::erase_if(jobs, [](const Job& job) { return !job.open(); });
  return {};
}

/// True when the read is complete.
bool SiiAccess::take(Job& job, bool looked_ahead) {
  auto& port = ports_[job.request->slave];
  const auto control = load_le<std::uint16_t>(job.window);
  const auto address = load_le<std::uint32_t>(std::span(job.window).subspan(2));
  if ((control & kSiiBusy) != 0) {
    const auto now = bus_.clock().now();
    job.busy_for = now - job.start_time;
    // Who has not shown yet how long it takes may take much longer; each look at it is a frame that the others wait
    // for.
    job.next_look = now + std::max(port.pace_shown ? *job.busy_for / 4 : *job.busy_for / 2, kShortestPause);
    if (*job.busy_for > kSiiBusyLimit) job.give_up("the EEPROM stays busy at word 0x{word}{which}");
    return false;
  }
  if ((control & kSiiCommandError) != 0) {
    job.started = false;
    job.failed_command = true;
    if (++job.errors == kSiiTries) job.give_up("the EEPROM acknowledges no read command at word 0x{word}{which}");
    return false;
  }
  if (port.reads_address_back && address != job.word()) {
    job.started = false;
    // Once may be a frame that was repeated, or a look ahead that came too early. An ESC that never shows
    // the address is believed without; one that has done so is not.
    if (port.pace_shown) {  // the look ahead was taken, because the look came just before the end of the read
      port.pace += std::max(port.pace / 16, kShortestPause);
      port.calm_reads = 0;
    }
    if (++job.mismatches < (looked_ahead || port.showed_address ? 2 * kSiiTries : kSiiTries)) return false;
    if (port.showed_address) {
      job.give_up("it reads other words than it is asked for at word 0x{word}");
    } else {
      port.reads_address_back = false;
    }
    return false;
  }
  port.showed_address = port.showed_address || (address != 0 && address == job.word());
  port.eight_bytes = (control & kSiiReadsEightBytes) != 0;
  const std::size_t count = std::min<std::size_t>(port.eight_bytes ? 8 : 4, 8 - job.got);
  std::copy_n(job.window.begin() + kSiiStatusBytes, count,
              job.request->data.begin() + static_cast<std::ptrdiff_t>(job.got));
  job.got += count;
  job.started = false;
  return job.got == 8;
}

/// Keeps the pause a little longer than the EEPROM needs: a look too early costs frames.
void SiiAccess::learn(const Job& job) {
  auto& port = ports_[job.request->slave];
  port.pace_shown = true;
  if (job.busy_for) {
    port.pace = bus_.clock().now() - job.start_time;
    port.too_early = *job.busy_for;
    port.calm_reads = 0;
  } else if (port.calm_reads < kSureReads) {
    ++port.calm_reads;
  } else if (port.pace > kShortestPause) {
    port.pace -= (port.pace - port.too_early) / 16;
  }
}

}  // namespace syncline
