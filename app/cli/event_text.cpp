// SPDX-License-Identifier: Apache-2.0
#include "app/cli/event_text.h"

#include <fmt/format.h>

#include <variant>

#include "app/cli/event_name.h"
#include "app/cli/run_json.h"
#include "dc/delay_text.h"
#include "dc/obstacle_text.h"
#include "families/families.h"
#include "protocol/dcm_error.h"
#include "protocol/error_text.h"

namespace syncline::cli {
namespace {

std::string who(int slave) { return slave < 0 ? "master" : fmt::format("slave {}", slave); }

std::string state_name(AlState state) { return state_text(static_cast<std::uint16_t>(state)); }

char port_letter(std::uint8_t port) { return static_cast<char>('A' + (port & 3)); }

std::string data_bytes(const std::array<std::uint8_t, 5>& data) { return fmt::format("{:02x}", fmt::join(data, " ")); }

/// " (A.A12, EtherCAT Outputs Data Synchronization Error)", or nothing.
std::string alarm_words(const events::Emergency& e) {
  const auto* alarm = families::find_alarm(e.identity, e.error_code, e.data);
  return alarm == nullptr || alarm->name.empty() ? "" : fmt::format(" ({}, {})", alarm->name, alarm->text);
}

std::string_view diagnosis_type(DiagnosisMessage::Type type) {
  switch (type) {
    case DiagnosisMessage::Type::kInfo:
      return "info";
    case DiagnosisMessage::Type::kWarning:
      return "warning";
    default:
      return "error";
  }
}

/// Without a form for any other: a new kind of event needs its words.
struct Words {
  int slave;

  [[nodiscard]] std::string subject() const { return who(slave); }

  // ---- scan
  std::string operator()(const events::ScanProgress&) const { return {}; }
  std::string operator()(const events::ScanTouchesRunning& e) const {
    return fmt::format(
        "a running machine is touched: {} slaves are beyond INIT. States and station addresses stay; {} EEPROMs "
        "are taken from their PDIs while they are read, and the DC receive times are latched. Use "
        "--look-only to change nothing",
        e.running, e.eeproms);
  }

  // ---- states
  std::string operator()(const events::Online&) const { return "online"; }
  std::string operator()(const events::Offline&) const { return "offline"; }
  std::string operator()(const events::StateChanged& e) const {
    return fmt::format("{}: {} -> {}", subject(), state_name(e.from), state_name(e.to));
  }
  std::string operator()(const events::AlStatusError& e) const {
    const auto text = al_status_code_text(e.al_status_code);
    return fmt::format("{}: {} with AL status code 0x{:04x}: {}. {}", subject(), state_text(e.al_status),
                       e.al_status_code, text.meaning, text.check);
  }
  std::string operator()(const events::SlaveLost&) const { return fmt::format("{} does not answer", subject()); }
  std::string operator()(const events::SlaveFound&) const { return fmt::format("{} answers again", subject()); }
  std::string operator()(const events::HotConnect& e) const {
    using What = events::HotConnect::What;
    return fmt::format("{}: {} (hot-connect group \"{}\")", subject(),
                       e.what == What::kConnected      ? "connected"
                       : e.what == What::kDisconnected ? "disconnected"
                                                       : "not there yet",
                       e.group.str());
  }
  std::string operator()(const events::RecoveryStep& e) const {
    using Stage = events::RecoveryStep::Stage;
    const auto text = [&]() -> std::string_view {
      switch (e.stage) {
        case Stage::kBegun:
          return "recovery begins";
        case Stage::kDone:
          return "recovered";
        case Stage::kFailed:
          return "recovery FAILED";
        case Stage::kGivenUp:
          break;
      }
      return "recovery given up; request the state again when the cause is removed";
    };
    return fmt::format("{}: {} (try {})", subject(), text(), e.tries);
  }

  // ---- clocks
  std::string operator()(const events::DcInitialised& e) const {
    return fmt::format("distributed clocks initialised: {} slaves, reference clock is slave {}", e.slaves,
                       e.reference_clock);
  }
  std::string operator()(const events::ReferenceClockChanged& e) const {
    using What = events::ReferenceClockChanged::What;
    const auto text = [&]() -> std::string_view {
      switch (e.what) {
        case What::kLost:
          return "LOST";
        case What::kTookOver:
          return "took over";
        case What::kNoSystemTime:
          return "has no system time (0x0910 does not answer), the next clock leads in its place";
        case What::kPresent:
          break;
      }
      return "present";
    };
    return fmt::format("reference clock {}: {}", subject(), text());
  }
  std::string operator()(const events::SlavesInSync& e) const {
    if (slave >= 0) return fmt::format("{} in sync again, deviation {} ns", subject(), e.deviation_ns);
    return fmt::format("slaves in sync, deviation {} ns", e.deviation_ns);
  }
  std::string operator()(const events::SlavesOutOfSync& e) const {
    if (slave < 0 && e.over_limit > 0) {
      return fmt::format(
          "slaves OUT OF SYNC, deviation {} ns: all {} at once and to the same side, the reference clock has stepped",
          e.deviation_ns, e.over_limit);
    }
    return fmt::format("slaves OUT OF SYNC, deviation {} ns{}{}", e.deviation_ns, slave < 0 ? "" : " at " + subject(),
                       e.over_limit > 1 ? fmt::format(" ({} slaves are over the limit)", e.over_limit) : "");
  }
  std::string operator()(const events::SlavesNotMonitored&) const { return "slaves not monitored"; }
  std::string operator()(const events::SlavesSyncUnknown& e) const {
    if (e.oldest_reading == 0) return "slaves: not known whether in sync, nobody leads them";
    return fmt::format("slaves: not known whether in sync, nothing was read for {} ms",
                       e.oldest_reading / kMillisecond);
  }
  std::string operator()(const events::MasterInSync& e) const {
    return fmt::format("master in sync, error {} ns", e.error);
  }
  std::string operator()(const events::MasterOutOfSync& e) const {
    return fmt::format("master OUT OF SYNC, error {} ns: {}", e.error, dc::obstacle_text(e.obstacle));
  }
  std::string operator()(const events::DcmError& e) const {
    return fmt::format("DCM error 0x{:08x} {}: {} The drift is {} ppm.", e.code, dc::dcm_error_name(e.code),
                       dc::dcm_error_text(e.code), e.drift_ppm);
  }
  std::string operator()(const events::DelayFinding& e) const {
    return fmt::format("{}: {}", subject(), delay_warning_text(e.warning, e.value));
  }
  std::string operator()(const events::DelaysMeasured& e) const {
    return e.corrected == 0 ? std::string("propagation delays measured again: nothing to correct")
                            : fmt::format("propagation delays measured again: {} slaves to correct, by {:+} ns at most",
                                          e.corrected, e.largest_ns);
  }

  // ---- frames
  std::string operator()(const events::WkcError& e) const {
    return fmt::format("working counter {} instead of {} ({} times)", e.received, e.expected, e.count);
  }
  std::string operator()(const events::WkcExpected& e) const {
    return fmt::format("working counter expected now {} (all slaves: {})", e.now, e.configured);
  }
  std::string operator()(const events::FramesLost& e) const {
    return fmt::format("{} {} lost", e.count, e.count == 1 ? "frame" : "frames");
  }
  std::string operator()(const events::FramesLate& e) const {
    return fmt::format("{} {} back late, up to {} us after the deadline{}", e.count, e.count == 1 ? "frame" : "frames",
                       e.late_by / kMicrosecond,
                       e.told_as_lost > 0 ? fmt::format(" ({} of them told as lost before)", e.told_as_lost) : "");
  }
  std::string operator()(const events::CyclesLeftOut& e) const {
    return fmt::format("{} {} left out, the host sent nothing for up to {:.1f} ms", e.count,
                       e.count == 1 ? "cycle" : "cycles",
                       static_cast<double>(e.standstill) / static_cast<double>(kMillisecond));
  }
  std::string operator()(const events::LinkDown& e) const {
    return fmt::format("network adapter {} is DOWN, gone or without carrier: waiting for it", e.adapter.str());
  }
  std::string operator()(const events::LinkUp& e) const {
    return fmt::format("network adapter {} is up again after {} ms", e.adapter.str(), e.away / kMillisecond);
  }
  std::string operator()(const events::BringUpAgain&) const {
    return "the bring-up begins again from INIT: the network adapter was away in the middle of it";
  }

  // ---- slaves
  std::string operator()(const events::Emergency& e) const {
    return fmt::format("{}: emergency 0x{:04x}{}, error register 0x{:02x}, data {}", subject(), e.error_code,
                       alarm_words(e), e.error_register, data_bytes(e.data));
  }
  std::string operator()(const events::DiagnosisTold& e) const {
    return fmt::format("{}: diagnosis {} 0x{:08x}, text {}{}", subject(), diagnosis_type(e.type), e.code,
                       e.text_id == 0 ? std::string("none") : fmt::format("0x{:04x}", e.text_id),
                       e.time_stamp == 0 ? std::string() : fmt::format(", time stamp {} ns", e.time_stamp));
  }
  std::string operator()(const events::PortErrors& e) const {
    std::string text = fmt::format("{} port {}:", subject(), port_letter(e.port));
    if (e.damaged_frames > 0) text += fmt::format(" {} damaged frames", e.damaged_frames);
    if (e.lost_links > 0) text += fmt::format("{} link lost {} times", e.damaged_frames > 0 ? "," : "", e.lost_links);
    return text;
  }
  std::string operator()(const events::WatchdogExpired& e) const {
    return e.which == events::WatchdogExpired::Which::kProcessData
               ? fmt::format("{}: process data watchdog expired ({} times)", subject(), e.count)
               : fmt::format("{}: PDI watchdog expired ({} times): its firmware is silent", subject(), e.count);
  }
  std::string operator()(const events::LongCycles& e) const {
    if (!e.begun) return fmt::format("{}: its cycles are short enough again", subject());
    return fmt::format("{}: {} of its cycles took longer than the cycle time: its firmware is slow", subject(),
                       e.count);
  }
  std::string operator()(const events::StaleInputs& e) const {
    if (!e.begun) return fmt::format("{}: it renews its inputs in every cycle again", subject());
    return fmt::format("{}: no new inputs in {} of {} cycles, where each brought some before: its firmware is slow",
                       subject(), e.stale, e.of);
  }
  std::string operator()(const events::CableChanged& e) const {
    return fmt::format("cable between {} port {} and {}: {}", subject(), port_letter(e.port), who(e.far_slave),
                       e.healed ? "healed" : "NOTHING COMES BACK (pulled, broken, or no power behind it)");
  }
  std::string operator()(const events::UnknownSlave& e) const {
    return fmt::format("unknown device at position {}: {}", slave, to_string(e.identity));
  }

  // ---- the master itself
  std::string operator()(const events::RealTimeRefused& e) const { return "real time: " + e.what; }
  std::string operator()(const events::Failure& e) const { return describe(e.error); }
  std::string operator()(const events::MasterStopped& e) const { return e.text; }
  std::string operator()(const events::EventsLost& e) const { return fmt::format("{} events were lost", e.count); }
};

}  // namespace

std::string event_words(const Event& event) { return std::visit(Words{event.slave}, event.what); }

Json event_json(const Event& event, Nanoseconds start) {
  auto text = event_words(event);
  if (text.empty()) return nullptr;
  return {{"time_ms", static_cast<double>((event.time - start) / 1000) / 1000},
          {"kind", event_name(event)},
          {"slave", event.slave < 0 ? Json(nullptr) : Json(event.slave)},
          {"text", std::move(text)}};
}

std::string event_text(const Event& event, Nanoseconds start) {
  const auto text = event_words(event);
  if (text.empty()) return {};
  return fmt::format("{:>10.3f} s  {}", static_cast<double>(event.time - start) / 1e9, text);
}

}  // namespace syncline::cli
