// SPDX-License-Identifier: Apache-2.0
#include "ui/text/event_text.h"

#include <QCoreApplication>
#include <optional>
#include <variant>

#include "families/families.h"
#include "ui/text/error_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QChar portLetter(std::int64_t port) { return QLatin1Char(static_cast<char>('A' + (port & 3))); }

/// Source text for lupdate's "Events" context. Without a form for any other: a new kind of event needs its words.
class EventWords {
  Q_DECLARE_TR_FUNCTIONS(Events)

 public:
  using Line = std::optional<Message>;
  explicit EventWords(int slave) : slave_(slave) {}

  // ---- scan
  Line operator()(const events::ScanProgress&) const { return std::nullopt; }
  Line operator()(const events::ScanTouchesRunning& e) const {
    return warning(
        tr("The scan touches a running machine: %1 slaves are beyond INIT. States and station addresses stay; "
           "%2 EEPROMs are taken from their PDIs while they are read, and the DC receive times are latched")
            .arg(e.running)
            .arg(e.eeproms));
  }

  // ---- states
  Line operator()(const events::Online&) const { return info(tr("Online: the master runs the configuration")); }
  Line operator()(const events::Offline&) const { return info(tr("Offline")); }
  Line operator()(const events::StateChanged& e) const {
    const auto name = [&](AlState state) { return slave_ < 0 ? masterStateName(state) : stateName(state); };
    return info(tr("State %1 → %2").arg(name(e.from), name(e.to)));
  }
  Line operator()(const events::AlStatusError& e) const {
    const auto text = al_status_code_text(e.al_status_code);
    return error(
        tr("AL status %1, code %2: %3. Check: %4")
            .arg(hexText(e.al_status, 4), hexText(e.al_status_code, 4), fromView(text.meaning), fromView(text.check)));
  }
  Line operator()(const events::SlaveLost&) const { return error(tr("Slave does not answer any more")); }
  Line operator()(const events::SlaveFound&) const { return info(tr("Slave answers again")); }
  Line operator()(const events::HotConnect& e) const;
  Line operator()(const events::RecoveryStep& e) const;

  // ---- clocks
  Line operator()(const events::DcInitialised& e) const {
    return info(tr("Distributed clocks initialised: %n slave(s), reference clock at position %1", nullptr,
                   static_cast<int>(e.slaves))
                    .arg(e.reference_clock));
  }
  Line operator()(const events::ReferenceClockChanged& e) const;
  Line operator()(const events::SlavesInSync& e) const {
    if (slave_ >= 0) return info(tr("In sync again, deviation %1").arg(timeText(e.deviation_ns)));
    return info(tr("All slaves in sync, deviation at most %1").arg(timeText(e.deviation_ns)));
  }
  Line operator()(const events::SlavesOutOfSync& e) const;
  Line operator()(const events::SlavesNotMonitored&) const {
    return info(tr("The slaves' deviation is not monitored"));
  }
  Line operator()(const events::SlavesSyncUnknown& e) const {
    if (e.oldest_reading == 0) return warning(tr("Not known whether the slaves are in sync: nobody leads them"));
    return warning(
        tr("Not known whether the slaves are in sync: nothing was read for %1").arg(timeText(e.oldest_reading)));
  }
  Line operator()(const events::MasterInSync& e) const {
    return info(tr("Master synchronisation in sync, error %1").arg(signedTimeText(e.error)));
  }
  Line operator()(const events::MasterOutOfSync& e) const {
    return warning(
        tr("Master synchronisation out of sync, error %1: %2").arg(signedTimeText(e.error), obstacleText(e.obstacle)));
  }
  Line operator()(const events::DcmError& e) const {
    return error(tr("Master synchronisation stopped with code %1 (drift %2). Measure the host's jitter, "
                    "or try master shift.")
                     .arg(hexText(e.code, 8), ppmText(static_cast<double>(e.drift_ppm))));
  }
  Line operator()(const events::DelayFinding& e) const;
  Line operator()(const events::DelaysMeasured& e) const {
    return info(e.corrected == 0 ? tr("Propagation delays measured again: nothing to correct")
                                 : tr("Propagation delays measured again: %n slave(s) to correct, by %1 at most",
                                      nullptr, static_cast<int>(e.corrected))
                                       .arg(signedTimeText(e.largest_ns)));
  }

  // ---- frames
  Line operator()(const events::WkcError& e) const {
    return warning(e.count > 1
                       ? tr("Working counter %1 instead of %2 (%3 times)").arg(e.received).arg(e.expected).arg(e.count)
                       : tr("Working counter %1 instead of %2").arg(e.received).arg(e.expected));
  }
  Line operator()(const events::WkcExpected& e) const {
    const auto text = tr("Working counter expected now %1 (all slaves: %2)").arg(e.now).arg(e.configured);
    return e.configured == e.now ? info(text) : warning(text);
  }
  Line operator()(const events::FramesLost& e) const {
    return warning(tr("%n frame(s) lost", nullptr, static_cast<int>(e.count)));
  }
  Line operator()(const events::FramesLate& e) const;
  Line operator()(const events::CyclesLeftOut& e) const {
    return warning(tr("%n cycle(s) left out, the host sent nothing for up to %1", nullptr, static_cast<int>(e.count))
                       .arg(timeText(e.standstill)));
  }
  Line operator()(const events::LinkDown& e) const {
    return error(tr("Network adapter %1 is down, gone or without carrier; waiting for it")
                     .arg(QString::fromStdString(e.adapter.str())));
  }
  Line operator()(const events::LinkUp& e) const {
    return info(
        tr("Network adapter %1 is up again after %2").arg(QString::fromStdString(e.adapter.str()), timeText(e.away)));
  }
  Line operator()(const events::BringUpAgain&) const {
    return info(tr("The bring-up begins again from INIT: the network adapter was away in the middle of it"));
  }

  // ---- slaves
  Line operator()(const events::Emergency& e) const;
  Line operator()(const events::DiagnosisTold& e) const;
  Line operator()(const events::PortErrors& e) const {
    const auto port = portLetter(e.port);
    return warning(
        e.lost_links > 0
            ? tr("Port %1: link lost %2 times, %3 damaged frames").arg(port).arg(e.lost_links).arg(e.damaged_frames)
            : tr("Port %1: %2 damaged frames").arg(port).arg(e.damaged_frames));
  }
  Line operator()(const events::WatchdogExpired& e) const {
    const auto count = static_cast<int>(e.count);
    return e.which == events::WatchdogExpired::Which::kProcessData
               ? warning(tr("Process data watchdog expired (%n time(s))", nullptr, count))
               : error(tr("PDI watchdog expired (%n time(s)): the firmware is silent", nullptr, count));
  }
  Line operator()(const events::LongCycles& e) const {
    if (!e.begun) return fastAgain();
    return warning(tr("The firmware is slow: %1 cycles took longer than the cycle time").arg(e.count));
  }
  Line operator()(const events::StaleInputs& e) const {
    if (!e.begun) return fastAgain();
    return warning(tr("The firmware is slow: no new inputs in %1 of %2 cycles").arg(e.stale).arg(e.of));
  }
  Line operator()(const events::CableChanged& e) const {
    const auto port = portLetter(e.port);
    if (e.healed) return info(tr("The cable from port %1 to position %2 is healed").arg(port).arg(e.far_slave));
    return error(
        tr("Nothing comes back over the cable from port %1 to position %2: pulled, broken, or no power behind it")
            .arg(port)
            .arg(e.far_slave));
  }
  Line operator()(const events::UnknownSlave& e) const {
    return error(tr("Device that is not in the configuration, at position %1: %2")
                     .arg(slave_)
                     .arg(QString::fromStdString(to_string(e.identity))));
  }

  // ---- the master itself
  Line operator()(const events::RealTimeRefused& e) const {
    return warning(tr("Best effort instead of real time: %1").arg(QString::fromStdString(e.what)));
  }
  Line operator()(const events::Failure& e) const { return error(errorText(e.error)); }
  Line operator()(const events::MasterStopped& e) const { return error(QString::fromStdString(e.text)); }
  Line operator()(const events::EventsLost& e) const {
    return warning(tr("%n event(s) were lost: the queue was full", nullptr, static_cast<int>(e.count)));
  }

 private:
  static Line line(Severity severity, const QString& text) { return Message{{}, severity, {}, text, -1, {}}; }
  static Line info(const QString& text) { return line(Severity::kNote, text); }
  static Line warning(const QString& text) { return line(Severity::kWarning, text); }
  static Line error(const QString& text) { return line(Severity::kError, text); }
  static Line fastAgain() { return info(tr("The firmware is fast enough again")); }

  int slave_;
};

EventWords::Line EventWords::operator()(const events::HotConnect& e) const {
  using What = events::HotConnect::What;
  const auto text = e.what == What::kConnected      ? tr("Connected (hot-connect group %1)")
                    : e.what == What::kDisconnected ? tr("Disconnected (hot-connect group %1)")
                                                    : tr("Not there yet (hot-connect group %1)");
  return info(text.arg(QString::fromStdString(e.group.str())));
}

EventWords::Line EventWords::operator()(const events::RecoveryStep& e) const {
  using Stage = events::RecoveryStep::Stage;
  switch (e.stage) {
    case Stage::kBegun:
      return info(tr("Recovery begins (try %1)").arg(e.tries));
    case Stage::kDone:
      return info(tr("Recovered (try %1)").arg(e.tries));
    case Stage::kFailed:
      return warning(tr("Recovery failed (try %1)").arg(e.tries));
    case Stage::kGivenUp:
      break;
  }
  return error(tr("Recovery given up after try %1; request the state again when the cause is removed").arg(e.tries));
}

EventWords::Line EventWords::operator()(const events::ReferenceClockChanged& e) const {
  using What = events::ReferenceClockChanged::What;
  switch (e.what) {
    case What::kTookOver:
      return warning(tr("This clock took over as reference clock"));
    case What::kNoSystemTime:
      return warning(
          tr("Configured as reference clock, but its system time (0x0910) does not answer: the "
             "next clock leads in its place"));
    case What::kLost:
      return error(tr("Reference clock lost"));
    case What::kPresent:
      break;
  }
  return info(tr("Reference clock present"));
}

EventWords::Line EventWords::operator()(const events::SlavesOutOfSync& e) const {
  if (slave_ < 0 && e.over_limit > 0) {
    return warning(tr("All slaves out of sync at once and to the same side, deviation %1: the reference "
                      "clock has stepped")
                       .arg(timeText(e.deviation_ns)));
  }
  return warning(e.over_limit > 1 ? tr("Slaves out of sync, deviation %1; %n slave(s) over the limit", nullptr,
                                       static_cast<int>(e.over_limit))
                                        .arg(timeText(e.deviation_ns))
                                  : tr("Slaves out of sync, deviation %1").arg(timeText(e.deviation_ns)));
}

EventWords::Line EventWords::operator()(const events::DelayFinding& e) const {
  switch (e.warning) {
    case dc::DelayWarning::kReversedCable:
      return warning(tr("Connected by port %1 instead of A: swap its cables IN and OUT. Its delay is right here, but "
                        "other masters "
                        "take it wrong without a word")
                         .arg(portLetter(e.value)));
    case dc::DelayWarning::kUnexplainedPort:
      return warning(
          tr("Port %1 has a link and no slave behind it: a closed ring or another master").arg(portLetter(e.value)));
    case dc::DelayWarning::kNegativeHop:
    case dc::DelayWarning::kImplausibleHop:
    case dc::DelayWarning::kNotIncreasing:
      break;
  }
  return warning(tr("Implausible propagation delay: %1").arg(signedTimeText(e.value)));
}

EventWords::Line EventWords::operator()(const events::FramesLate& e) const {
  const auto count = static_cast<int>(e.count);
  return warning(
      e.told_as_lost > 0
          ? tr("%n frame(s) back late, up to %1 after the deadline (%2 of them told as lost before)", nullptr, count)
                .arg(timeText(e.late_by))
                .arg(e.told_as_lost)
          : tr("%n frame(s) back late, up to %1 after the deadline", nullptr, count).arg(timeText(e.late_by)));
}

EventWords::Line EventWords::operator()(const events::Emergency& e) const {
  QStringList bytes;
  for (const auto byte : e.data) bytes += QStringLiteral("%1").arg(byte, 2, 16, QLatin1Char('0'));
  auto code = hexText(e.error_code, 4);
  if (const auto* alarm = families::find_alarm(e.identity, e.error_code, e.data); alarm && !alarm->name.empty()) {
    code += QStringLiteral(" (%1, %2)").arg(fromView(alarm->name), fromView(alarm->text));
  }
  return warning(tr("Emergency %1, error register %2, data %3")
                     .arg(code, hexText(e.error_register, 2), bytes.join(QLatin1Char(' '))));
}

EventWords::Line EventWords::operator()(const events::DiagnosisTold& e) const {
  using Type = DiagnosisMessage::Type;
  const auto severity = e.type == Type::kInfo      ? Severity::kNote
                        : e.type == Type::kWarning ? Severity::kWarning
                                                   : Severity::kError;
  return line(severity, tr("Diagnosis message %1, text %2, time stamp %3 ns")
                            .arg(hexText(e.code, 8), hexText(e.text_id, 4))
                            .arg(e.time_stamp));
}

}  // namespace

QDateTime dateTimeOf(Nanoseconds dc_time) {
  return QDateTime::fromMSecsSinceEpoch(kDcEpochUnixSeconds * 1000 + dc_time / kMillisecond);
}

namespace {

template <class Network>
std::optional<Message> messageIn(const Event& event, const Network& network) {
  auto message = std::visit(EventWords(event.slave), event.what);
  if (!message) return std::nullopt;
  message->time = dateTimeOf(event.time);
  message->moment = event.time;
  message->slave = event.slave;
  message->source = nodeName(network, event.slave);
  return message;
}

}  // namespace

std::optional<Message> messageOf(const Event& event, const Project& project) { return messageIn(event, project); }
std::optional<Message> messageOf(const Event& event, const NetworkConfig& running) { return messageIn(event, running); }

Message messageOf(const Finding& finding, const Project& project) {
  const auto advice = findingAdvice(finding);
  const auto text = findingText(finding);
  return {{},
          finding.severity,
          nodeName(project, finding.place.slave),
          advice.isEmpty() ? text : text + QLatin1Char(' ') + advice,
          finding.place.slave,
          QString::fromStdString(finding.place.key)};
}

Message messageOf(const Error& error, Severity severity, const QString& source) {
  return {QDateTime::currentDateTime(), severity, source, errorText(error), -1, {}};
}

}  // namespace syncline::ui
