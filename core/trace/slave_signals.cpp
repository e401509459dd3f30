// SPDX-License-Identifier: Apache-2.0
#include "trace/slave_signals.h"

#include <array>

#include "channels/slave_evidence.h"
#include "channels/slave_status.h"
#include "channels/snapshot.h"
#include "protocol/speed_counter.h"
#include "trace/counted_at_least.h"

namespace syncline {
namespace {

using Reading = std::optional<SlaveReading>;
using Form = SignalInfo::Form;
using Scale = SignalInfo::Scale;
using Clock = SignalInfo::Clock;
using OfSlave = Reading (*)(const Snapshot&, const SlaveStatus&, std::uint16_t);

/// Misses raise the integrator by 3, good cycles lower it by 1 (ETG.1020, 0x10F1:02).
constexpr std::uint32_t kPerMiss = 3;

Reading counted(const EvidenceCount& count) {
  return count.valid() ? Reading({count.time, static_cast<double>(count.total)}) : std::nullopt;
}

/// The followed count holds as long as the slave answers; the slave's own is as old as its last reading.
Reading sm2(const Snapshot& snapshot, const SlaveStatus& slave, double value) {
  const auto& misses = slave.sm2_missed;
  if (misses.known) return SlaveReading{snapshot.time, value};
  return misses.valid ? Reading({misses.time, value}) : std::nullopt;
}

Reading sm2_missed(const Snapshot& snapshot, const SlaveStatus& slave, std::uint16_t) {
  return sm2(snapshot, slave, slave.sm2_missed.total());
}
Reading sm2_integrator(const Snapshot& snapshot, const SlaveStatus& slave, std::uint16_t) {
  const auto& misses = slave.sm2_missed;
  return misses.known && !misses.settling ? sm2(snapshot, slave, misses.integrator) : std::nullopt;
}
Reading sm2_limit(const Snapshot& snapshot, const SlaveStatus& slave, std::uint16_t) {
  return slave.sm2_missed.limit > 0 ? sm2(snapshot, slave, slave.sm2_missed.limit) : std::nullopt;
}
Reading sm2_cycles_to_trip(const Snapshot& snapshot, const SlaveStatus& slave, std::uint16_t) {
  const auto& misses = slave.sm2_missed;
  if (!misses.known || misses.settling || misses.limit == 0) return std::nullopt;
  const auto rest = misses.limit > misses.integrator ? misses.limit - misses.integrator : 0;
  const auto cycles = (rest + kPerMiss - 1) / kPerMiss;
  return sm2(snapshot, slave, cycles);
}

Reading clock_rate(const Snapshot&, const SlaveStatus& slave, std::uint16_t speed_counter_start) {
  const auto& evidence = slave.evidence;
  if (evidence.speed_counter_time == 0 || speed_counter_start == 0) return std::nullopt;
  return SlaveReading{evidence.speed_counter_time,
                      speed_counter_rate(speed_counter_start, evidence.speed_counter_difference) * 1e6};
}

Reading al_state(const Snapshot& snapshot, const SlaveStatus& slave, std::uint16_t) {
  return slave.al_status != 0 ? Reading({snapshot.time, static_cast<double>(slave.al_status)}) : std::nullopt;
}

Reading propagation_delay(const Snapshot& snapshot, const SlaveStatus& slave, std::uint16_t) {
  return slave.dc_enabled ? Reading({snapshot.time, static_cast<double>(slave.propagation_delay_ns)}) : std::nullopt;
}

/// Nothing while all are exact.
Reading at_least(const Snapshot& snapshot, const SlaveStatus& slave, std::uint16_t) {
  const auto bits = counts_at_least(slave);
  return bits != 0 ? Reading({snapshot.time, static_cast<double>(bits)}) : std::nullopt;
}

template <auto Count>
Reading port_count(const SlaveStatus& slave, std::size_t port) {
  const auto& evidence = slave.evidence;
  if (evidence.ports_time == 0) return std::nullopt;
  return SlaveReading{evidence.ports_time, static_cast<double>(evidence.ports[port].*Count)};
}
template <std::size_t Port, auto Count>
Reading of_port(const Snapshot&, const SlaveStatus& slave, std::uint16_t) {
  return port_count<Count>(slave, Port);
}

constexpr SignalInfo count(Signal id, std::string_view key, std::string_view name, std::string_view source,
                           OfSlave of_slave, std::string_view since = "going online") {
  return {
      id,           key,     name,    "",      source, since, SignalInfo::Scope::kSlave, Form::kHeld, Scale::kLinear,
      Clock::kNone, nullptr, nullptr, of_slave};
}
constexpr SignalInfo momentary(Signal id, std::string_view key, std::string_view name, std::string_view unit,
                               std::string_view source, Scale scale, OfSlave of_slave, Clock clock = Clock::kNone) {
  return {id,          key,   name,  unit,    source,  "",      SignalInfo::Scope::kSlave,
          Form::kHeld, scale, clock, nullptr, nullptr, of_slave};
}

constexpr std::string_view kSinceKnown = "OP, the last gap, or the last change of state, base or delay";
constexpr std::string_view kSinceOp = "the slave being in OP first";

constexpr std::array kSlaveRows{
    SignalInfo{Signal::kSlaveDeviation, "deviation_ns", "Deviation", "ns", "register 0x092C, signed", "",
               SignalInfo::Scope::kSlave, Form::kReadings, Scale::kSignedLog, Clock::kSlaves, nullptr, nullptr,
               nullptr},
    count(Signal::kSm2Missed, "sm2_missed", "SM2 events missed", "object 0x1C32:0B or 0x1C32:0C", sm2_missed, kSinceOp),
    momentary(Signal::kSm2Integrator, "sm2_integrator", "Fuse", "", "+3 for a miss, -1 for a good cycle, object 0x10F1",
              Scale::kLinear, sm2_integrator),
    momentary(Signal::kSm2Limit, "sm2_limit", "Fuse limit", "", "object 0x10F1:02", Scale::kLinear, sm2_limit),
    momentary(Signal::kSm2CyclesToTrip, "sm2_cycles_to_trip", "Misses until the fuse trips", "", "object 0x10F1:02",
              Scale::kLinear, sm2_cycles_to_trip),
    count(Signal::kOutputsExceeded, "outputs_cycle_exceeded", "Cycle exceeded, outputs", "object 0x1C32:0B and kin",
          [](const Snapshot&, const SlaveStatus& s, std::uint16_t) { return counted(s.evidence.outputs.exceeded); }),
    count(Signal::kInputsExceeded, "inputs_cycle_exceeded", "Cycle exceeded, inputs", "object 0x1C33:0B and kin",
          [](const Snapshot&, const SlaveStatus& s, std::uint16_t) { return counted(s.evidence.inputs.exceeded); }),
    count(Signal::kOutputsShiftTooShort, "outputs_shift_too_short", "Shift too short, outputs", "object 0x1C32:0D",
          [](const Snapshot&, const SlaveStatus& s, std::uint16_t) {
            return counted(s.evidence.outputs.shift_too_short);
          }),
    count(Signal::kInputsShiftTooShort, "inputs_shift_too_short", "Shift too short, inputs", "object 0x1C33:0D",
          [](const Snapshot&, const SlaveStatus& s, std::uint16_t) {
            return counted(s.evidence.inputs.shift_too_short);
          }),
    momentary(Signal::kClockRate, "clock_rate_ppm", "Clock slowed by", "ppm", "registers 0x0930 and 0x0932",
              Scale::kLinear, clock_rate, Clock::kSlaves),
    momentary(Signal::kAlState, "al_status", "AL status", "", "register 0x0130", Scale::kBand, al_state),
    count(
        Signal::kProcessDataWatchdog, "process_data_watchdog", "Process data watchdog", "register 0x0442",
        [](const Snapshot&, const SlaveStatus& s, std::uint16_t) { return counted(s.evidence.process_data_watchdog); }),
    count(Signal::kPdiWatchdog, "pdi_watchdog", "PDI watchdog", "register 0x0443",
          [](const Snapshot&, const SlaveStatus& s, std::uint16_t) { return counted(s.evidence.pdi_watchdog); }),
    count(Signal::kProcessingUnitErrors, "processing_unit_errors", "Processing unit errors", "register 0x030C",
          [](const Snapshot&, const SlaveStatus& s, std::uint16_t) {
            return counted(s.evidence.processing_unit_errors);
          }),
    count(Signal::kPdiErrors, "pdi_errors", "PDI errors", "register 0x030D",
          [](const Snapshot&, const SlaveStatus& s, std::uint16_t) { return counted(s.evidence.pdi_errors); }),
    momentary(Signal::kPropagationDelay, "propagation_delay_ns", "Propagation delay", "ns", "register 0x0928",
              Scale::kLinear, propagation_delay, Clock::kSlaves),
    SignalInfo{Signal::kArrivalPhase, "arrival_phase_ns", "Arrival phase", "ns",
               "end of the frame with the outputs, behind SYNC0 in system time", "", SignalInfo::Scope::kSlave,
               Form::kDerived, Scale::kLinear, Clock::kSlaves, nullptr, nullptr, nullptr},
    count(Signal::kSetpointSlips, "setpoint_slips", "Setpoint slips",
          "SYNC0 periods into which no frame came, or more than are due", nullptr, kSinceKnown),
    momentary(Signal::kCountsAtLeast, "counts_at_least", "Counts that may be higher", "",
              "counters that stood at their end stop, or were cleared between two readings", Scale::kBand, at_least),
};

template <std::size_t Port>
void put_port(SignalTable& table) {
  // Texts that live as long as the program: the table holds views.
  static constexpr const char* kKeys[kPorts][kPortSignals] = {
      {"port0_invalid_frames", "port0_receive_errors", "port0_forwarded_errors", "port0_lost_links"},
      {"port1_invalid_frames", "port1_receive_errors", "port1_forwarded_errors", "port1_lost_links"},
      {"port2_invalid_frames", "port2_receive_errors", "port2_forwarded_errors", "port2_lost_links"},
      {"port3_invalid_frames", "port3_receive_errors", "port3_forwarded_errors", "port3_lost_links"}};
  static constexpr const char* kNames[kPorts][kPortSignals] = {
      {"Port 0: invalid frames", "Port 0: receive errors", "Port 0: forwarded errors", "Port 0: lost links"},
      {"Port 1: invalid frames", "Port 1: receive errors", "Port 1: forwarded errors", "Port 1: lost links"},
      {"Port 2: invalid frames", "Port 2: receive errors", "Port 2: forwarded errors", "Port 2: lost links"},
      {"Port 3: invalid frames", "Port 3: receive errors", "Port 3: forwarded errors", "Port 3: lost links"}};
  static constexpr const char* kRegisters[kPorts][kPortSignals] = {
      {"register 0x0300", "register 0x0301", "register 0x0308", "register 0x0310"},
      {"register 0x0302", "register 0x0303", "register 0x0309", "register 0x0311"},
      {"register 0x0304", "register 0x0305", "register 0x030A", "register 0x0312"},
      {"register 0x0306", "register 0x0307", "register 0x030B", "register 0x0313"}};
  const OfSlave counts[kPortSignals] = {
      of_port<Port, &PortErrors::invalid_frames>, of_port<Port, &PortErrors::receive_errors>,
      of_port<Port, &PortErrors::forwarded_errors>, of_port<Port, &PortErrors::lost_links>};
  for (std::size_t kind = 0; kind < kPortSignals; ++kind) {
    put_signal(table, count(port_signal(Port, static_cast<PortSignal>(kind)), kKeys[Port][kind], kNames[Port][kind],
                            kRegisters[Port][kind], counts[kind]));
  }
}

}  // namespace

void put_slave_signals(SignalTable& table) {
  for (const auto& row : kSlaveRows) put_signal(table, row);
  put_port<0>(table);
  put_port<1>(table);
  put_port<2>(table);
  put_port<3>(table);
}

}  // namespace syncline
