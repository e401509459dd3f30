// SPDX-License-Identifier: Apache-2.0
#include "ui/text/event_text.h"

#include <QCoreApplication>

#include "config/families/families.h"
#include "dc/propagation_delay.h"
#include "ui/text/error_text.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

/// Source text for lupdate's "Events" context.
class Words {
  Q_DECLARE_TR_FUNCTIONS(Events)

 public:
  static std::optional<Message> make(const Event& event);

 private:
  static Message line(Severity severity, const QString& text) { return {{}, severity, {}, text, -1, {}}; }
  static Message stateChanged(const Event& event);
  static Message alStatusError(const Event& event);
  static Message dcmError(const Event& event);
  static Message emergency(const Event& event);
  static Message diagnosis(const Event& event);
  static Message cable(const Event& event);
  static Message recovery(const Event& event);
  static Message slaveSync(const Event& event);
  static Message delayFinding(const Event& event);
};

QString fromView(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

Message Words::stateChanged(const Event& event) {
  const auto name = [&](std::int64_t state) {
    const auto al_state = static_cast<AlState>(state);
    return event.slave < 0 ? masterStateName(al_state) : stateName(al_state);
  };
  return line(Severity::kInfo, tr("State %1 → %2").arg(name(event.a), name(event.b)));
}

Message Words::alStatusError(const Event& event) {
  const auto code = static_cast<std::uint16_t>(event.b);
  const auto text = al_status_code_text(code);
  return line(Severity::kError, tr("AL status %1, code %2: %3. Check: %4")
                                    .arg(hexText(static_cast<std::uint64_t>(event.a), 4), hexText(code, 4),
                                         fromView(text.meaning), fromView(text.check)));
}

Message Words::dcmError(const Event& event) {
  return line(Severity::kError, tr("Master synchronisation stopped with code %1 (drift %2). Measure the host's jitter, "
                                   "or try master shift.")
                                    .arg(hexText(static_cast<std::uint64_t>(event.a), 8),
                                         ppmText(static_cast<double>(event.b))));
}

Message Words::emergency(const Event& event) {
  QStringList bytes;
  for (int i = 0; i < 5; ++i) bytes += QStringLiteral("%1").arg((event.c >> (8 * i)) & 0xFF, 2, 16, QLatin1Char('0'));
  auto code = hexText(static_cast<std::uint64_t>(event.a), 4);
  if (const auto* alarm = families::find_alarm(event.text)) {
    code += QStringLiteral(" (%1, %2)").arg(fromView(alarm->name), fromView(alarm->text));
  }
  return line(Severity::kWarning, tr("Emergency %1, error register %2, data %3")
                                      .arg(code, hexText(static_cast<std::uint64_t>(event.b), 2), bytes.join(QLatin1Char(' '))));
}

Message Words::diagnosis(const Event& event) {
  const auto type = event.b & 0xF;
  const auto severity = type == 0 ? Severity::kInfo : type == 1 ? Severity::kWarning : Severity::kError;
  const auto text_id = static_cast<std::uint64_t>(event.b >> 16) & 0xFFFF;
  return line(severity, tr("Diagnosis message %1, text %2, time stamp %3 ns")
                            .arg(hexText(static_cast<std::uint64_t>(event.a), 8), hexText(text_id, 4))
                            .arg(static_cast<std::uint64_t>(event.c)));
}

Message Words::cable(const Event& event) {
  const QChar port = QLatin1Char(static_cast<char>('A' + (event.a & 3)));
  return event.c != 0 ? line(Severity::kInfo, tr("The cable from port %1 to position %2 is healed").arg(port).arg(event.b))
                      : line(Severity::kError, tr("Nothing comes back over the cable from port %1 to position %2: pulled, "
                                                  "broken, or no power behind it")
                                                   .arg(port)
                                                   .arg(event.b));
}

Message Words::delayFinding(const Event& event) {
  switch (static_cast<dc::DelayWarning>(event.a)) {
    case dc::DelayWarning::kReversedCable:
      return line(Severity::kWarning, tr("Connected by port %1 instead of A: swap its cables IN and OUT. Its delay is right here, but other masters "
                                         "take it wrong without a word")
                                          .arg(QChar('A' + static_cast<int>(event.b & 3))));
    case dc::DelayWarning::kUnexplainedPort:
      return line(Severity::kWarning, tr("Port %1 has a link and no slave behind it: a closed ring or another master")
                                          .arg(QChar('A' + static_cast<int>(event.b & 3))));
    case dc::DelayWarning::kNegativeHop:
    case dc::DelayWarning::kImplausibleHop:
    case dc::DelayWarning::kNotIncreasing:
      break;
  }
  return line(Severity::kWarning, tr("Implausible propagation delay: %1").arg(signedTimeText(event.b)));
}

Message Words::recovery(const Event& event) {
  switch (event.a) {
    case 0:
      return line(Severity::kInfo, tr("Recovery begins (try %1)").arg(event.b));
    case 1:
      return line(Severity::kInfo, tr("Recovered (try %1)").arg(event.b));
    case 2:
      return line(Severity::kWarning, tr("Recovery failed (try %1)").arg(event.b));
    default:
      return line(Severity::kError, tr("Recovery given up after try %1; request the state again when the cause is removed")
                                        .arg(event.b));
  }
}

Message Words::slaveSync(const Event& event) {
  switch (event.a) {
    case 0:
      if (event.slave < 0 && event.c > 0) {
        return line(Severity::kWarning, tr("All slaves out of sync at once and to the same side, deviation %1: the reference "
                                           "clock has stepped").arg(timeText(event.b)));
      }
      return line(Severity::kWarning, event.c > 1 ? tr("Slaves out of sync, deviation %1; %n slave(s) over the limit", nullptr,
                                                       static_cast<int>(event.c)).arg(timeText(event.b))
                                                  : tr("Slaves out of sync, deviation %1").arg(timeText(event.b)));
    case 2:
      return line(Severity::kInfo, tr("The slaves' deviation is not monitored"));
    case 3:
      if (event.b == 0) return line(Severity::kWarning, tr("Not known whether the slaves are in sync: nobody leads them"));
      return line(Severity::kWarning, tr("Not known whether the slaves are in sync: nothing was read for %1").arg(timeText(event.b)));
    default:
      if (event.slave >= 0) return line(Severity::kInfo, tr("In sync again, deviation %1").arg(timeText(event.b)));
      return line(Severity::kInfo, tr("All slaves in sync, deviation at most %1").arg(timeText(event.b)));
  }
}

std::optional<Message> Words::make(const Event& event) {
  switch (event.kind) {
    case EventKind::kScanProgress:
    case EventKind::kRestarted:
      return std::nullopt;
    case EventKind::kScanFinished:
      return line(Severity::kInfo, tr("Scan finished"));
    case EventKind::kScanTouchesRunning:
      return line(Severity::kWarning,
                  tr("The scan touches a running machine: %1 slaves are beyond INIT. States and station addresses stay; "
                     "%2 EEPROMs are taken from their PDIs while they are read, and the DC receive times are latched")
                      .arg(event.a)
                      .arg(event.b));
    case EventKind::kOnline:
      return line(Severity::kInfo, tr("Online: the master runs the configuration"));
    case EventKind::kOffline:
      return line(Severity::kInfo, tr("Offline"));
    case EventKind::kStateChanged:
      return stateChanged(event);
    case EventKind::kAlStatusError:
      return alStatusError(event);
    case EventKind::kDcInitialised:
      return line(Severity::kInfo, tr("Distributed clocks initialised: %n slave(s), reference clock at position %1",
                                      nullptr, static_cast<int>(event.a))
                                       .arg(event.b));
    case EventKind::kReferenceClock:
      if (event.a == 2) return line(Severity::kWarning, tr("This clock took over as reference clock"));
      if (event.a == 3) {
        return line(Severity::kWarning, tr("Configured as reference clock, but its system time (0x0910) does not answer: the "
                                           "next clock leads in its place"));
      }
      return event.a != 0 ? line(Severity::kInfo, tr("Reference clock present"))
                          : line(Severity::kError, tr("Reference clock lost"));
    case EventKind::kDcSlaveSync:
      return slaveSync(event);
    case EventKind::kDcmSync:
      return event.a != 0
                 ? line(Severity::kInfo, tr("Master synchronisation in sync, error %1").arg(signedTimeText(event.b)))
                 : line(Severity::kWarning, tr("Master synchronisation out of sync, error %1: %2")
                                                .arg(signedTimeText(event.b), obstacleText(static_cast<dc::SyncObstacle>(event.c))));
    case EventKind::kDcmError:
      return dcmError(event);
    case EventKind::kWkcError:
      return line(Severity::kWarning, event.c > 1
                      ? tr("Working counter %1 instead of %2 (%3 times)").arg(event.b).arg(event.a).arg(event.c)
                      : tr("Working counter %1 instead of %2").arg(event.b).arg(event.a));
    case EventKind::kFramesLost:
      return line(Severity::kWarning, tr("%n frame(s) lost", nullptr, static_cast<int>(event.a)));
    case EventKind::kFramesLate:
      return line(Severity::kWarning, event.c > 0
                      ? tr("%n frame(s) back late, up to %1 after the deadline (%2 of them told as lost before)", nullptr,
                           static_cast<int>(event.a)).arg(timeText(event.b)).arg(event.c)
                      : tr("%n frame(s) back late, up to %1 after the deadline", nullptr, static_cast<int>(event.a))
                            .arg(timeText(event.b)));
    case EventKind::kOverrun:
      return line(Severity::kWarning, tr("%n cycle(s) left out, the host sent nothing for up to %1", nullptr,
                                         static_cast<int>(event.a)).arg(timeText(event.b)));
    case EventKind::kPortErrors: {
      const QChar port = QLatin1Char(static_cast<char>('A' + (event.a & 3)));
      return event.c > 0 ? line(Severity::kWarning, tr("Port %1: link lost %2 times, %3 damaged frames").arg(port).arg(event.c).arg(event.b))
                         : line(Severity::kWarning, tr("Port %1: %2 damaged frames").arg(port).arg(event.b));
    }
    case EventKind::kWatchdog:
      return event.a == 0 ? line(Severity::kWarning, tr("Process data watchdog expired (%n time(s))", nullptr, static_cast<int>(event.b)))
                          : line(Severity::kError, tr("PDI watchdog expired (%n time(s)): the firmware is silent", nullptr,
                                                      static_cast<int>(event.b)));
    case EventKind::kFirmwareSlow:
      if (event.a == 0) return line(Severity::kInfo, tr("The firmware is fast enough again"));
      return event.c == 0 ? line(Severity::kWarning, tr("The firmware is slow: %1 cycles took longer than the cycle time").arg(event.b))
                          : line(Severity::kWarning, tr("The firmware is slow: no new inputs in %1 of %2 cycles").arg(event.b).arg(event.c));
    case EventKind::kSlaveLost:
      return line(Severity::kError, tr("Slave does not answer any more"));
    case EventKind::kSlaveFound:
      return line(Severity::kInfo, tr("Slave answers again"));
    case EventKind::kEmergency:
      return emergency(event);
    case EventKind::kDiagnosis:
      return diagnosis(event);
    case EventKind::kHotConnect: {
      const auto text = event.a == 1   ? tr("Connected (hot-connect group %1)")
                        : event.a == 0 ? tr("Disconnected (hot-connect group %1)")
                                       : tr("Not there yet (hot-connect group %1)");
      return line(Severity::kInfo, text.arg(QString::fromStdString(event.text)));
    }
    case EventKind::kRealTime:
      return line(Severity::kWarning, tr("Best effort instead of real time: %1").arg(QString::fromStdString(event.text)));
    case EventKind::kError:
      return line(Severity::kError, event.error ? errorText(*event.error) : QString::fromStdString(event.text));
    case EventKind::kEventsLost:
      return line(Severity::kWarning, tr("%n event(s) were lost: the queue was full", nullptr, static_cast<int>(event.a)));
    case EventKind::kCable:
      return cable(event);
    case EventKind::kWkcExpected:
      return line(event.a == event.b ? Severity::kInfo : Severity::kWarning,
                  tr("Working counter expected now %1 (all slaves: %2)").arg(event.b).arg(event.a));
    case EventKind::kRecovery:
      return recovery(event);
    case EventKind::kUnknownSlave:
      return line(Severity::kError, tr("Device that is not in the configuration, at position %1: %2")
                                        .arg(event.slave)
                                        .arg(QString::fromStdString(event.text)));
    case EventKind::kDelayFinding:
      return delayFinding(event);
    case EventKind::kLink: {
      const auto name = QString::fromStdString(event.text);
      if (event.a == 2) {
        return line(Severity::kInfo, tr("The bring-up begins again from INIT: the network adapter was away in the middle of it"));
      }
      return event.a == 0 ? line(Severity::kError, tr("Network adapter %1 is down, gone or without carrier; waiting for it").arg(name))
                          : line(Severity::kInfo, tr("Network adapter %1 is up again after %2").arg(name, timeText(event.b)));
    }
    case EventKind::kDelaysMeasured:
      return line(Severity::kInfo, event.a == 0
                                       ? tr("Propagation delays measured again: nothing to correct")
                                       : tr("Propagation delays measured again: %n slave(s) to correct, by %1 at most",
                                            nullptr, static_cast<int>(event.a))
                                             .arg(signedTimeText(event.b)));
  }
  return std::nullopt;
}

Severity severityOf(FindingSeverity severity) {
  switch (severity) {
    case FindingSeverity::kError:
      return Severity::kError;
    case FindingSeverity::kWarning:
      return Severity::kWarning;
    case FindingSeverity::kInfo:
      break;
  }
  return Severity::kInfo;
}

}  // namespace

QDateTime dateTimeOf(Nanoseconds dc_time) {
  return QDateTime::fromMSecsSinceEpoch(kDcEpochUnixSeconds * 1000 + dc_time / kMillisecond);
}

std::optional<Message> messageOf(const Event& event, const Project& project) {
  auto message = Words::make(event);
  if (!message) return std::nullopt;
  message->time = dateTimeOf(event.time);
  message->slave = event.slave;
  message->source = nodeName(project, event.slave);
  return message;
}

Message messageOf(const Finding& finding, const Project& project) {
  return {{},
          severityOf(finding.severity),
          nodeName(project, finding.slave),
          QString::fromStdString(finding.text),
          finding.slave,
          QString::fromStdString(finding.key)};
}

Message messageOf(const Error& error, Severity severity, const QString& source) {
  return {QDateTime::currentDateTime(), severity, source, errorText(error), -1, {}};
}

}  // namespace syncline::ui
