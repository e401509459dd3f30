// SPDX-License-Identifier: Apache-2.0
#include "app/cli/event_text.h"

#include <fmt/format.h>

#include "app/cli/run_json.h"
#include "config/families/families.h"
#include "protocol/dcm_error.h"
#include "dc/delay_text.h"
#include "dc/obstacle_text.h"
#include "protocol/error_text.h"

namespace syncline::cli {
namespace {

std::string who(int slave) { return slave < 0 ? "master" : fmt::format("slave {}", slave); }

std::string state_name(std::int64_t state) { return state_text(static_cast<std::uint16_t>(state & 0x0F)); }

std::string_view reference_clock_text(std::int64_t what) {
  switch (what) {
    case 0: return "LOST";
    case 2: return "took over";
    case 3: return "has no system time (0x0910 does not answer), the next clock leads in its place";
    default: return "present";
  }
}

std::string_view kind_name(EventKind kind) {
  switch (kind) {
    case EventKind::kScanProgress: return "scan_progress";
    case EventKind::kScanFinished: return "scan_finished";
    case EventKind::kScanTouchesRunning: return "scan_touches_running";
    case EventKind::kOnline: return "online";
    case EventKind::kOffline: return "offline";
    case EventKind::kStateChanged: return "state";
    case EventKind::kAlStatusError: return "al_status_error";
    case EventKind::kDcInitialised: return "dc_initialised";
    case EventKind::kReferenceClock: return "reference_clock";
    case EventKind::kDcSlaveSync: return "slave_sync";
    case EventKind::kDcmSync: return "master_sync";
    case EventKind::kDcmError: return "dcm_error";
    case EventKind::kWkcError: return "wkc_error";
    case EventKind::kFramesLost: return "frames_lost";
    case EventKind::kFramesLate: return "frames_late";
    case EventKind::kOverrun: return "overruns";
    case EventKind::kSlaveLost: return "slave_lost";
    case EventKind::kSlaveFound: return "slave_found";
    case EventKind::kEmergency: return "emergency";
    case EventKind::kRealTime: return "real_time";
    case EventKind::kError: return "error";
    case EventKind::kEventsLost: return "events_lost";
    case EventKind::kCable: return "cable";
    case EventKind::kWkcExpected: return "wkc_expected";
    case EventKind::kRecovery: return "recovery";
    case EventKind::kUnknownSlave: return "unknown_slave";
    case EventKind::kDiagnosis: return "diagnosis";
    case EventKind::kHotConnect: return "hot_connect";
    case EventKind::kDelayFinding: return "delay_finding";
    case EventKind::kDelaysMeasured: return "delays_measured";
    case EventKind::kPortErrors: return "port_errors";
    case EventKind::kWatchdog: return "watchdog";
    case EventKind::kLink: return "link";
    case EventKind::kFirmwareSlow: return "firmware_slow";
    default: return "other";
  }
}

char port_letter(std::int64_t port) { return static_cast<char>('A' + (port & 3)); }

std::string firmware_slow(const Event& e) {
  if (e.c == 0 && e.a == 0) return fmt::format("{}: its cycles are short enough again", who(e.slave));
  if (e.c == 0) return fmt::format("{}: {} of its cycles took longer than the cycle time: its firmware is slow", who(e.slave), e.b);
  if (e.a == 0) return fmt::format("{}: it renews its inputs in every cycle again", who(e.slave));
  return fmt::format("{}: no new inputs in {} of {} cycles, where each brought some before: its firmware is slow", who(e.slave), e.b,
                     e.c);
}

std::string_view recovery_text(std::int64_t stage) {
  switch (stage) {
    case 0: return "recovery begins";
    case 1: return "recovered";
    case 2: return "recovery FAILED";
    default: return "recovery given up; request the state again when the cause is removed";
  }
}

/// 5 bytes, the first one lowest.
std::string data_bytes(std::int64_t data) {
  std::string text;
  for (int i = 0; i < 5; ++i) text += fmt::format("{}{:02x}", i == 0 ? "" : " ", (data >> (8 * i)) & 0xFF);
  return text;
}

/// " (A.A12, EtherCAT Outputs Data Synchronization Error)", or nothing.
std::string alarm_words(const Event& e) {
  const auto* alarm = families::find_alarm(e.text);
  return alarm == nullptr ? "" : fmt::format(" ({}, {})", alarm->name, alarm->text);
}

std::string_view diagnosis_type(std::int64_t type) {
  switch (type & 0xF) {
    case 0: return "info";
    case 1: return "warning";
    default: return "error";
  }
}

std::string diagnosis(const Event& e) {
  const auto text_id = (e.b >> 16) & 0xFFFF;
  return fmt::format("{}: diagnosis {} 0x{:08x}, text {}{}", who(e.slave), diagnosis_type(e.b), e.a,
                     text_id == 0 ? std::string("none") : fmt::format("0x{:04x}", text_id),
                     e.c == 0 ? std::string() : fmt::format(", time stamp {} ns", e.c));
}

std::string slave_sync(const Event& e) {
  switch (e.a) {
    case 0:
      if (e.slave < 0 && e.c > 0) {
        return fmt::format("slaves OUT OF SYNC, deviation {} ns: all {} at once and to the same side, the reference clock has stepped",
                           e.b, e.c);
      }
      return fmt::format("slaves OUT OF SYNC, deviation {} ns{}{}", e.b, e.slave < 0 ? "" : " at " + who(e.slave),
                         e.c > 1 ? fmt::format(" ({} slaves are over the limit)", e.c) : "");
    case 2: return "slaves not monitored";
    case 3:
      if (e.b == 0) return "slaves: not known whether in sync, nobody leads them";
      return fmt::format("slaves: not known whether in sync, nothing was read for {} ms", e.b / kMillisecond);
    default:
      if (e.slave >= 0) return fmt::format("{} in sync again, deviation {} ns", who(e.slave), e.b);
      return fmt::format("slaves in sync, deviation {} ns", e.b);
  }
}

std::string port_errors(const Event& e) {
  std::string text = fmt::format("{} port {}:", who(e.slave), port_letter(e.a));
  if (e.b > 0) text += fmt::format(" {} damaged frames", e.b);
  if (e.c > 0) text += fmt::format("{} link lost {} times", e.b > 0 ? "," : "", e.c);
  return text;
}

std::string words(const Event& e) {
  switch (e.kind) {
    case EventKind::kScanProgress: return {};
    case EventKind::kScanFinished: return "scan finished";
    case EventKind::kScanTouchesRunning:
      return fmt::format("a running machine is touched: {} slaves are beyond INIT. States and station addresses stay; {} EEPROMs "
                         "are taken from their PDIs while they are read, and the DC receive times are latched. Use "
                         "--look-only to change nothing", e.a, e.b);
    case EventKind::kOnline: return "online";
    case EventKind::kOffline: return "offline";
    case EventKind::kStateChanged: return fmt::format("{}: {} -> {}", who(e.slave), state_name(e.a), state_name(e.b));
    case EventKind::kAlStatusError: {
      const auto text = al_status_code_text(static_cast<std::uint16_t>(e.b));
      return fmt::format("{}: {} with AL status code 0x{:04x}: {}. {}", who(e.slave),
                         state_text(static_cast<std::uint16_t>(e.a)), e.b, text.meaning, text.check);
    }
    case EventKind::kDcInitialised: return fmt::format("distributed clocks initialised: {} slaves, reference clock is slave {}", e.a, e.b);
    case EventKind::kReferenceClock: return fmt::format("reference clock {}: {}", who(e.slave), reference_clock_text(e.a));
    case EventKind::kDcSlaveSync:
      return slave_sync(e);
    case EventKind::kDcmSync:
      if (e.a != 0) return fmt::format("master in sync, error {} ns", e.b);
      return fmt::format("master OUT OF SYNC, error {} ns: {}", e.b, dc::obstacle_text(static_cast<dc::SyncObstacle>(e.c)));
    case EventKind::kDcmError: {
      const auto code = static_cast<std::uint32_t>(e.a);
      return fmt::format("DCM error 0x{:08x} {}: {} The drift is {} ppm.", code, dc::dcm_error_name(code),
                         dc::dcm_error_text(code), e.b);
    }
    case EventKind::kWkcError: return fmt::format("working counter {} instead of {} ({} times)", e.b, e.a, e.c);
    case EventKind::kFramesLost: return fmt::format("{} {} lost", e.a, e.a == 1 ? "frame" : "frames");
    case EventKind::kFramesLate:
      return fmt::format("{} {} back late, up to {} us after the deadline{}", e.a, e.a == 1 ? "frame" : "frames",
                         e.b / kMicrosecond, e.c > 0 ? fmt::format(" ({} of them told as lost before)", e.c) : "");
    case EventKind::kOverrun:
      return fmt::format("{} {} left out, the host sent nothing for up to {:.1f} ms", e.a, e.a == 1 ? "cycle" : "cycles",
                         static_cast<double>(e.b) / static_cast<double>(kMillisecond));
    case EventKind::kSlaveLost: return fmt::format("{} does not answer", who(e.slave));
    case EventKind::kSlaveFound: return fmt::format("{} answers again", who(e.slave));
    case EventKind::kEmergency:
      return fmt::format("{}: emergency 0x{:04x}{}, error register 0x{:02x}, data {}", who(e.slave), e.a, alarm_words(e), e.b,
                         data_bytes(e.c));
    case EventKind::kRealTime: return "real time: " + e.text;
    case EventKind::kError: return e.error ? describe(*e.error) : e.text;
    case EventKind::kEventsLost: return fmt::format("{} events were lost", e.a);
    case EventKind::kCable:
      return fmt::format("cable between {} port {} and {}: {}", who(e.slave), port_letter(e.a), who(static_cast<int>(e.b)),
                         e.c != 0 ? "healed" : "NOTHING COMES BACK (pulled, broken, or no power behind it)");
    case EventKind::kWkcExpected: return fmt::format("working counter expected now {} (all slaves: {})", e.b, e.a);
    case EventKind::kRecovery: return fmt::format("{}: {} (try {})", who(e.slave), recovery_text(e.a), e.b);
    case EventKind::kUnknownSlave: return fmt::format("unknown device at position {}: {}", e.slave, e.text);
    case EventKind::kDiagnosis: return diagnosis(e);
    case EventKind::kHotConnect:
      return fmt::format("{}: {} (hot-connect group \"{}\")", who(e.slave),
                         e.a == 1 ? "connected" : e.a == 0 ? "disconnected" : "not there yet", e.text);
    case EventKind::kDelayFinding:
      return fmt::format("{}: {}", who(e.slave), delay_warning_text(static_cast<dc::DelayWarning>(e.a), e.b));
    case EventKind::kDelaysMeasured:
      return e.a == 0 ? std::string("propagation delays measured again: nothing to correct")
                      : fmt::format("propagation delays measured again: {} slaves to correct, by {:+} ns at most", e.a, e.b);
    case EventKind::kPortErrors: return port_errors(e);
    case EventKind::kWatchdog:
      return e.a == 0 ? fmt::format("{}: process data watchdog expired ({} times)", who(e.slave), e.b)
                      : fmt::format("{}: PDI watchdog expired ({} times): its firmware is silent", who(e.slave), e.b);
    case EventKind::kFirmwareSlow: return firmware_slow(e);
    case EventKind::kLink:
      if (e.a == 2) return "the bring-up begins again from INIT: the network adapter was away in the middle of it";
      return e.a == 0 ? fmt::format("network adapter {} is DOWN, gone or without carrier: waiting for it", e.text)
                      : fmt::format("network adapter {} is up again after {} ms", e.text, e.b / kMillisecond);
    case EventKind::kRestarted: return e.text;
    default: return e.text;
  }
}

}  // namespace

std::string event_words(const Event& event) { return words(event); }

Json event_json(const Event& event, Nanoseconds start) {
  auto text = words(event);
  if (text.empty()) return nullptr;
  return {{"time_ms", static_cast<double>((event.time - start) / 1000) / 1000},
          {"kind", kind_name(event.kind)},
          {"slave", event.slave < 0 ? Json(nullptr) : Json(event.slave)},
          {"text", std::move(text)}};
}

std::string event_text(const Event& event, Nanoseconds start) {
  const auto text = words(event);
  if (text.empty()) return {};
  return fmt::format("{:>10.3f} s  {}", static_cast<double>(event.time - start) / 1e9, text);
}

}  // namespace syncline::cli
