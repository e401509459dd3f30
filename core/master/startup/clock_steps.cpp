// SPDX-License-Identifier: Apache-2.0
#include "master/startup/clock_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "channels/values/sync_obstacle_text.h"
#include "config/dc_settings.h"
#include "master/clocks/dc_join.h"
#include "master/clocks/dc_setup.h"
#include "master/clocks/dc_start.h"
#include "master/clocks/delay_compensation.h"
#include "master/cyclic/cyclic_task.h"
#include "master/exchange/slave_name.h"
#include "master/startup/attendance.h"
#include "protocol/dcm_error.h"
#include "reasons/because.h"

namespace syncline {
namespace {

constexpr Nanoseconds kSyncTimeout = 30 * kSecond;
/// So long nobody has led: while the bus is brought up nobody new is made one, and no waiting helps.
constexpr Nanoseconds kLeaderless = kSecond;

}  // namespace

Result<Nanoseconds> ClockSteps::initialise(SlaveList present) {
  std::optional<DcNetwork> network;
  if (configured_reference_clock(run_.config())) {
    auto result = DcSetup(bus_, run_.config(), std::move(present)).run();
    if (!result) return tl::unexpected(result.error());
    network = std::move(*result);
    note(*network);
  }
  auto first_cycle = bus_.clock().now() + run_.config().cycle_time();
  if (network) {
    first_cycle = sync_.first_cycle(*network, first_cycle);
    sync_.start(*network, first_cycle);
    delays_.start(*network, first_cycle);
  }
  return first_cycle;
}

std::uint32_t ClockSteps::estimated_delay(std::size_t slave) const {
  constexpr std::uint32_t kUsualHop = 500;  // ns: an ESC with copper ports and some metres of cable
  const auto& previous = run_.config().slaves[slave].previous;
  if (!previous || previous->position >= run_.snapshot.slaves.size()) return 0;
  return run_.snapshot.slaves[previous->position].propagation_delay_ns + kUsualHop;
}

void ClockSteps::note(const DcNetwork& network) {
  std::vector<std::uint16_t> watched;
  for (std::size_t i = 0; i < network.slaves.size(); ++i) {
    const auto& clock = network.slaves[i];
    auto& slave = run_.snapshot.slaves[i];
    slave.dc_enabled = clock.synchronised;
    slave.is_reference_clock = i == network.reference_clock;
    slave.propagation_delay_ns = clock.delay_ns;
    // One that joins later gets its clock then.
    if (attendance_.missing(i) && run_.config().slaves[i].dc) {
      slave.dc_enabled = true;
      slave.propagation_delay_ns = estimated_delay(i);
    }
    if (slave.dc_enabled) watched.push_back(static_cast<std::uint16_t>(i));
  }
  run_.states.note_slave_change();
  task_.slaves().set_dc_slaves(std::move(watched));
  for (const auto& finding : network.findings) {
    run_.teller.tell(bus_.clock().now(), finding.position, events::DelayFinding{finding.warning, finding.value_ns});
  }
  const bool configured = network.reference_clock == configured_reference_clock(run_.config());
  task_.reference().start(network.home, network.reference_clock, configured && attendance_.complete());
  const auto now = bus_.clock().now();
  using What = events::ReferenceClockChanged::What;
  if (network.without_time)
    run_.teller.tell(now, *network.without_time, events::ReferenceClockChanged{What::kNoSystemTime});
  run_.teller.tell(now, network.reference_clock, events::ReferenceClockChanged{What::kPresent});
}

Result<bool> ClockSteps::comes_true(bool (SyncWatch::*in_sync)() const) {
  const auto end = bus_.clock().now() + kSyncTimeout;
  auto led = bus_.clock().now();
  while (!(sync_.*in_sync)()) {
    if (auto status = bus_.wait_a_little(); !status) return tl::unexpected(status.error());
    const auto now = bus_.clock().now();
    if (task_.reference().leader()) led = now;
    if (!run_.states.somebody_present()) return fail(ErrorCode::kNoResponse, bus_.exchange().link().describe().name);
    if (now - led >= kLeaderless) {
      return fail(ErrorCode::kDcSetup, "the slaves",
                  because("the reference clock has been away for {time} s", kLeaderless / kSecond));
    }
    if (now >= end) return false;
  }
  return true;
}

Status ClockSteps::await_slaves() {
  if (!sync_.active()) return {};
  const auto in_sync = comes_true(&SyncWatch::slaves_in_sync);
  if (!in_sync) return tl::unexpected(in_sync.error());
  if (!*in_sync) {
    const auto& dc = run_.snapshot.dc;
    const auto by = dc.deviation_ns.value_or(dc.deviation_ored_ns);
    const auto after = kSyncTimeout / kSecond;
    if (by <= dc.limit_ns) {
      return fail(ErrorCode::kDcSetup, "the slaves",
                  because("they did not stay within {limit} ns of the reference clock for {settle} ms in {time} s",
                          dc.limit_ns, run_.config().dc.sync_window.settle_time_ms, after));
    }
    if (dc.culprit < 0) {
      return fail(ErrorCode::kDcSetup, "the slaves",
                  because("they are {by} ns from the reference clock after {time} s, the sync window allows {limit} ns",
                          by, after, dc.limit_ns));
    }
    return fail(ErrorCode::kDcSetup, "the slaves",
                because("{slave} {by} ns from the reference clock after {time} s, the sync window allows {limit} ns",
                        slave_name(run_.config(), static_cast<std::size_t>(dc.culprit)), by, after, dc.limit_ns));
  }
  const auto now = bus_.clock().now();
  if (!sync_.monitored()) run_.teller.tell(now, -1, events::SlavesNotMonitored{});
  std::size_t count = 0;
  for (const auto& slave : run_.snapshot.slaves) count += slave.dc_enabled && slave.present ? 1 : 0;
  run_.teller.tell(now, -1, events::DcInitialised{count, run_.snapshot.dc.reference_clock});
  return {};
}

Status ClockSteps::await_master() {
  if (!sync_.active()) return {};
  const auto in_sync = comes_true(&SyncWatch::schedule_in_sync);
  if (!in_sync) return tl::unexpected(in_sync.error());
  if (*in_sync) return {};
  const auto& dcm = run_.snapshot.dcm;
  Error error{ErrorCode::kDcmOutOfLimit, "master"};
  error.expected = run_.config().dc.dcm.in_sync_limit;
  error.received = dcm.error_ns;
  if (dcm.error_code == 0 && std::abs(error.received) > error.expected) return fail(std::move(error));
  const auto why = dcm.error_code != 0 ? dc::dcm_error_text(dcm.error_code) : dc::obstacle_text(dcm.obstacle);
  return fail(ErrorCode::kDcSetup, "the master",
              because("it is not in sync after {time} s: {reason}", kSyncTimeout / kSecond, Reason::phrase(why)));
}

Status ClockSteps::join(const SlaveList& slaves) {
  if (!sync_.active()) return {};
  auto& reference = task_.reference();
  DcJoin join(bus_, run_.config(), run_.snapshot, sync_, task_.feed(), reference.home());
  auto others = slaves;
  if (const auto first = reference.leader() ? std::nullopt : reference.candidate(slaves)) {
    // Nobody has kept the time: it goes on with the master's own idea of it.
    const std::size_t leader = *first;
    if (auto status = join.run({&leader, 1}, std::nullopt); !status) return status;
    reference.lead(*first, bus_.clock().now());
    std::erase(others, leader);
  }
  return join.run(others, reference.leader());
}

/// What is read is evidence, too: it stays with the slave.
Result<std::vector<DcStartReading>> ClockSteps::read_sync_signals(const SlaveList& slaves) {
  auto readings = read_dc_start(bus_, run_.config(), slaves);
  if (!readings) return readings;
  const auto now = bus_.clock().now();
  for (const auto& reading : *readings) {
    auto& start = run_.snapshot.slaves[reading.slave].evidence.sync0;
    start = {now, reading.error.has_value(), 0};
    // Who gives the start times himself has a grid of his own.
    if (!reading.next || sync_.start_time()) continue;
    start.off_ns = static_cast<std::int32_t>(sync0_off_grid(run_.config(), *run_.config().slaves[reading.slave].dc,
                                                            *reading.next, sync_.base(), sync_.reference_time_at(now)));
  }
  return readings;
}

Result<SlaveList> ClockSteps::without_sync_signals(const SlaveList& slaves) {
  SlaveList without;
  if (!sync_.active()) return without;
  const auto readings = read_sync_signals(slaves);
  if (!readings) return tl::unexpected(readings.error());
  for (const auto& reading : *readings) {
    if (reading.error) without.push_back(reading.slave);
  }
  return without;
}

Status ClockSteps::check_sync_signals(const SlaveList& slaves) {
  if (!sync_.active()) return {};
  const auto readings = read_sync_signals(slaves);
  if (!readings) return tl::unexpected(readings.error());
  Status result;
  for (const auto& reading : *readings) {
    if (!reading.error) continue;
    run_.teller.error(*reading.error, bus_.clock().now());
    if (result) result = fail(*reading.error);
  }
  return result;
}

}  // namespace syncline
