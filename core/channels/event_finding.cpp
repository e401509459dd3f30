// SPDX-License-Identifier: Apache-2.0
#include "channels/event_finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "channels/event.h"
#include "channels/events/clock_events.h"
#include "channels/events/frame_events.h"
#include "channels/events/slave_events.h"
#include "channels/events/state_events.h"
#include "channels/values/sync_obstacle_text.h"
#include "families/device_family.h"
#include "families/families.h"
#include "findings/error_text.h"
#include "findings/event_words.h"
#include "findings/sentence.h"
#include "protocol/al_state.h"
#include "protocol/dcm_error.h"

namespace syncline {
namespace {

using Told = std::optional<Finding>;

/// Who an event is about, in its words; no figure of kSlave where it is the master.
Named<"subject"> event_subject(int slave) {
  return slave < 0 ? fig::phrase<"subject">("master") : fig::slave<"subject">(static_cast<std::size_t>(slave));
}

Finding with(Finding finding, Severity severity) {
  finding.severity = severity;
  return finding;
}

/// Without a form for any other: a new kind of event needs its words.
struct ToldByEvent {
  int slave;

  [[nodiscard]] Named<"subject"> subject() const { return event_subject(slave); }
  template <FigureName... kNames>
  [[nodiscard]] Finding tell(std::type_identity_t<FindingSentence<words::kEvents, kNames...>> sentence,
                             Named<kNames>... figures) const {
    return make_finding<words::kEvents>(sentence, slave, std::move(figures)...);
  }

  // ---- scan
  Told operator()(const events::ScanProgress&) const { return std::nullopt; }
  Told operator()(const events::ScanTouchesRunning& e) const {
    return tell("event-scan-touches-running", fig::count<"running">(e.running), fig::count<"eeproms">(e.eeproms));
  }

  // ---- states
  static std::string_view state_name(AlState state) {
    return state == AlState::kNone ? "unknown" : al_state_name(state);
  }
  Told operator()(const events::Online&) const { return tell("event-online"); }
  Told operator()(const events::Offline&) const { return tell("event-offline"); }
  Told operator()(const events::StateChanged& e) const {
    return tell("event-state", subject(), fig::phrase<"from">(state_name(e.from)), fig::phrase<"to">(state_name(e.to)));
  }
  Told operator()(const events::AlStatusError& e) const;
  Told operator()(const events::LeftUnasked& e) const {
    return tell("event-left-unasked", subject(), fig::phrase<"from">(state_name(e.from)),
                fig::phrase<"to">(state_name(e.to)));
  }
  Told operator()(const events::BusWasRunning&) const { return tell("event-bus-was-running"); }
  Told operator()(const events::SlaveLost&) const { return tell("event-slave-lost", subject()); }
  Told operator()(const events::SlaveFound&) const { return tell("event-slave-found", subject()); }
  Told operator()(const events::HotConnect& e) const;
  Told operator()(const events::RecoveryStep& e) const;

  // ---- clocks
  Told operator()(const events::DcInitialised& e) const;
  Told operator()(const events::ReferenceClockChanged& e) const;
  Told operator()(const events::SlavesInSync& e) const {
    auto deviation = fig::measured<"deviation">(e.deviation_ns);
    return slave < 0 ? tell("event-slaves-in-sync", std::move(deviation))
                     : tell("event-slaves-in-sync/again", subject(), std::move(deviation));
  }
  Told operator()(const events::SlavesOutOfSync& e) const;
  Told operator()(const events::FramesWayChanged& e) const {
    return tell("event-frames-way-changed", fig::measured<"deviation">(e.deviation_ns), subject(),
                fig::count<"slaves">(e.slaves));
  }
  Told operator()(const events::SlavesNotMonitored&) const { return tell("event-slaves-not-monitored"); }
  Told operator()(const events::SlavesSyncUnknown& e) const {
    return e.oldest_reading == 0 ? tell("event-slaves-sync-unknown/unled")
                                 : tell("event-slaves-sync-unknown", fig::measured<"age">(e.oldest_reading));
  }
  Told operator()(const events::MasterInSync& e) const {
    return tell("event-master-in-sync", fig::measured<"error">(e.error));
  }
  Told operator()(const events::MasterOutOfSync& e) const {
    return tell("event-master-out-of-sync", fig::measured<"error">(e.error),
                fig::aside<"because">(dc::obstacle_text(e.obstacle)));
  }
  Told operator()(const events::DcmError& e) const {
    return tell("event-dcm-error", fig::hex<"code">(e.code, 8),
                fig::text<"name">(std::string(dc::dcm_error_name(e.code))),
                fig::phrase<"text">(dc::dcm_error_text(e.code)), fig::count<"drift">(e.drift_ppm));
  }
  Told operator()(const events::DelayFinding& e) const { return delay_finding(slave, e.warning, e.value); }
  Told operator()(const events::DelaysMeasured& e) const {
    if (e.corrected == 0) return tell("event-delays-measured/nothing");
    auto largest = fig::measured<"largest">(e.largest_ns);
    return e.corrected == 1 ? tell("event-delays-measured/one", std::move(largest))
                            : tell("event-delays-measured", fig::count<"slaves">(e.corrected), std::move(largest));
  }

  // ---- frames
  Told operator()(const events::WkcError& e) const {
    auto received = fig::count<"received">(e.received);
    auto expected = fig::count<"expected">(e.expected);
    return e.count > 1
               ? tell("event-working-counter", std::move(received), std::move(expected), fig::count<"count">(e.count))
               : tell("event-working-counter/once", std::move(received), std::move(expected));
  }
  Told operator()(const events::WkcExpected& e) const {
    return with(
        tell("event-working-counter-expected", fig::count<"now">(e.now), fig::count<"configured">(e.configured)),
        e.now == e.configured ? Severity::kNote : Severity::kWarning);
  }
  Told operator()(const events::FramesLost& e) const { return tell("event-frames-lost", fig::count<"count">(e.count)); }
  Told operator()(const events::FramesLate& e) const;
  Told operator()(const events::CyclesLeftOut& e) const {
    auto standstill = fig::measured<"standstill">(e.standstill);
    return e.count == 1 ? tell("event-cycles-left-out/one", std::move(standstill))
                        : tell("event-cycles-left-out", fig::count<"count">(e.count), std::move(standstill));
  }
  Told operator()(const events::LinkDown& e) const {
    return tell("event-link-down", fig::text<"adapter">(std::string(e.adapter.str())));
  }
  Told operator()(const events::LinkUp& e) const {
    return tell("event-link-up", fig::text<"adapter">(std::string(e.adapter.str())), fig::measured<"away">(e.away));
  }
  Told operator()(const events::BringUpAgain&) const { return tell("event-bring-up-again"); }

  // ---- slaves
  Told operator()(const events::Emergency& e) const;
  Told operator()(const events::DiagnosisTold& e) const;
  Told operator()(const events::PortErrors& e) const;
  Told operator()(const events::WatchdogExpired& e) const {
    return e.which == events::WatchdogExpired::Which::kProcessData
               ? tell("event-watchdog", subject(), fig::times<"count">(e.count))
               : tell("event-pdi-watchdog", subject(), fig::times<"count">(e.count));
  }
  Told operator()(const events::LongCycles& e) const {
    return e.begun ? tell("event-firmware-slow", subject(), fig::count<"count">(e.count))
                   : tell("event-firmware-fast", subject());
  }
  Told operator()(const events::StaleProcessData& e) const {
    const auto stale = fig::count<"stale">(e.stale);
    const auto cycles = fig::count<"cycles">(e.of);
    if (e.outputs)
      return e.begun ? tell("event-firmware-slow/outputs", subject(), stale, cycles)
                     : tell("event-firmware-fast/outputs", subject());
    return e.begun ? tell("event-firmware-slow/inputs", subject(), stale, cycles)
                   : tell("event-firmware-fast/inputs", subject());
  }
  Told operator()(const events::CableChanged& e) const {
    Named<"far"> far{event_subject(e.far_slave).figure};
    far.figure.name = "far";
    return e.healed ? tell("event-cable-healed", subject(), fig::port<"port">(e.port), std::move(far))
                    : tell("event-cable-broken", subject(), fig::port<"port">(e.port), std::move(far));
  }
  Told operator()(const events::UnknownSlave& e) const {
    return tell("event-unknown-slave", fig::number<"position">(slave), fig::text<"identity">(to_string(e.identity)));
  }

  // ---- the master itself
  Told operator()(const events::RealTimeRefused& e) const { return tell("event-real-time", fig::text<"what">(e.what)); }
  Told operator()(const events::OutputsForced& e) const {
    return e.bits == 0 ? tell("event-outputs-released") : tell("event-outputs-forced", fig::count<"bits">(e.bits));
  }
  Told operator()(const events::Failure& e) const { return finding_of(e.error); }
  Told operator()(const events::MasterStopped& e) const {
    return tell("event-master-stopped", fig::text<"text">(e.text));
  }
  Told operator()(const events::EventsLost& e) const { return tell("event-events-lost", fig::count<"count">(e.count)); }
};

Told ToldByEvent::operator()(const events::AlStatusError& e) const {
  const auto check = al_status_code_text(e.al_status_code).check;
  auto status = fig::of<"status">(Figure::Unit::kAlStatus, e.al_status);
  auto code = fig::of<"code">(Figure::Unit::kAlCode, e.al_status_code);
  if (check.empty()) return tell("event-al-status/unchecked", subject(), std::move(status), std::move(code));
  return tell("event-al-status", subject(), std::move(status), std::move(code), fig::phrase<"check">(check));
}

Told ToldByEvent::operator()(const events::HotConnect& e) const {
  using What = events::HotConnect::What;
  auto group = fig::text<"group">(std::string(e.group.str()));
  if (e.what == What::kConnected) return tell("event-hot-connect/connected", subject(), std::move(group));
  if (e.what == What::kDisconnected) return tell("event-hot-connect/disconnected", subject(), std::move(group));
  return tell("event-hot-connect", subject(), std::move(group));
}

Told ToldByEvent::operator()(const events::RecoveryStep& e) const {
  using Stage = events::RecoveryStep::Stage;
  auto tries = fig::count<"tries">(e.tries);
  switch (e.stage) {
    case Stage::kBegun:
      return tell("event-recovery", subject(), std::move(tries));
    case Stage::kDone:
      return tell("event-recovery/done", subject(), std::move(tries));
    case Stage::kFailed:
      return tell("event-recovery-failed", subject(), std::move(tries));
    case Stage::kGivenUp:
      break;
  }
  return tell("event-recovery-given-up", subject(), std::move(tries));
}

Told ToldByEvent::operator()(const events::DcInitialised& e) const {
  if (e.reference_clock < 0) return tell("event-dc-initialised/unled", fig::count<"slaves">(e.slaves));
  auto clock = fig::slave<"clock">(static_cast<std::size_t>(e.reference_clock));
  return tell("event-dc-initialised", fig::count<"slaves">(e.slaves), std::move(clock));
}

Told ToldByEvent::operator()(const events::ReferenceClockChanged& e) const {
  using What = events::ReferenceClockChanged::What;
  switch (e.what) {
    case What::kLost:
      return tell("event-reference-clock-lost", subject());
    case What::kTookOver:
      return tell("event-reference-clock-changed", subject());
    case What::kNoSystemTime:
      return tell("event-reference-clock-changed/no-system-time", subject());
    case What::kPresent:
      break;
  }
  return tell("event-reference-clock", subject());
}

Told ToldByEvent::operator()(const events::SlavesOutOfSync& e) const {
  auto deviation = fig::measured<"deviation">(e.deviation_ns);
  if (slave < 0) {
    return e.over_limit == 0
               ? tell("event-slaves-out-of-sync", std::move(deviation))
               : tell("event-slaves-out-of-sync/stepped", std::move(deviation), fig::count<"slaves">(e.over_limit));
  }
  return e.over_limit > 1 ? tell("event-slaves-out-of-sync/several", std::move(deviation), subject(),
                                 fig::count<"slaves">(e.over_limit))
                          : tell("event-slaves-out-of-sync/at", std::move(deviation), subject());
}

Told ToldByEvent::operator()(const events::FramesLate& e) const {
  auto late = fig::measured<"late">(e.late_by);
  if (e.count == 1) {
    return e.told_as_lost > 0 ? tell("event-frames-late/one-told", std::move(late))
                              : tell("event-frames-late/one", std::move(late));
  }
  auto count = fig::count<"count">(e.count);
  return e.told_as_lost > 0
             ? tell("event-frames-late/told", std::move(count), std::move(late), fig::count<"told">(e.told_as_lost))
             : tell("event-frames-late", std::move(count), std::move(late));
}

Told ToldByEvent::operator()(const events::Emergency& e) const {
  auto code = fig::hex<"code">(e.error_code);
  auto error_register = fig::hex<"register">(e.error_register, 2);
  auto data = fig::text<"data">(fmt::format("{:02x}", fmt::join(e.data, " ")));
  const auto* alarm = families::find_alarm(e.identity, e.error_code, e.data);
  if (alarm == nullptr || alarm->name.empty())
    return tell("event-emergency", subject(), std::move(code), std::move(error_register), std::move(data));
  return tell("event-emergency/alarm", subject(), std::move(code), fig::text<"alarm">(std::string(alarm->name)),
              fig::text<"text">(std::string(alarm->text)), std::move(error_register), std::move(data));
}

Told ToldByEvent::operator()(const events::DiagnosisTold& e) const {
  using Type = DiagnosisMessageType;
  const auto severity = e.type == Type::kInfo      ? Severity::kNote
                        : e.type == Type::kWarning ? Severity::kWarning
                                                   : Severity::kError;
  auto type = fig::phrase<"type">(e.type == Type::kInfo ? "info" : severity_name(severity));
  auto code = fig::hex<"code">(e.code, 8);
  auto text = e.text_id == 0 ? fig::phrase<"text">("none") : fig::hex<"text">(e.text_id);
  if (e.time_stamp == 0)
    return with(tell("event-diagnosis", subject(), std::move(type), std::move(code), std::move(text)), severity);
  return with(tell("event-diagnosis/stamped", subject(), std::move(type), std::move(code), std::move(text),
                   fig::time<"stamp">(static_cast<Nanoseconds>(std::min<std::uint64_t>(e.time_stamp, INT64_MAX)))),
              severity);
}

Told ToldByEvent::operator()(const events::PortErrors& e) const {
  auto port = fig::port<"port">(e.port);
  auto damaged = fig::count<"damaged">(e.damaged_frames);
  if (e.lost_links == 0) return tell("event-port-errors", subject(), std::move(port), std::move(damaged));
  auto lost = fig::times<"lost">(e.lost_links);
  return e.damaged_frames == 0
             ? tell("event-port-errors/link", subject(), std::move(port), std::move(lost))
             : tell("event-port-errors/both", subject(), std::move(port), std::move(damaged), std::move(lost));
}

}  // namespace

std::optional<Finding> event_finding(const Event& event) { return std::visit(ToldByEvent{event.slave}, event.what); }

Finding delay_finding(int slave, dc::DelayWarning warning, std::int64_t value) {
  const ToldByEvent of{slave};
  auto delay = fig::measured<"delay">(value);
  auto port = fig::port<"port">(static_cast<std::uint64_t>(value));
  switch (warning) {
    case dc::DelayWarning::kReversedCable:
      return of.tell("event-delay/reversed", of.subject(), std::move(port));
    case dc::DelayWarning::kUnexplainedPort:
      return of.tell("event-delay/unexplained", of.subject(), std::move(port));
    case dc::DelayWarning::kUntimedPort:
      return of.tell("event-delay/untimed", of.subject(), std::move(port));
    case dc::DelayWarning::kImplausibleHop:
      return of.tell("event-delay/implausible", of.subject(), std::move(delay));
    case dc::DelayWarning::kUnmeasuredWay:
      return of.tell("event-delay/unmeasured", of.subject(), std::move(delay));
    case dc::DelayWarning::kNotIncreasing:
      return of.tell("event-delay/not-increasing", of.subject(), std::move(delay));
    case dc::DelayWarning::kNegativeHop:
      break;
  }
  return of.tell("event-delay", of.subject(), std::move(delay));
}

}  // namespace syncline
