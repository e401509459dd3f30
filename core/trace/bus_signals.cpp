// SPDX-License-Identifier: Apache-2.0
#include "trace/bus_signals.h"

#include <array>
#include <limits>
#include <utility>

#include "channels/snapshot.h"
#include "trace/untold.h"

namespace syncline {
namespace {

using Flag = CycleSample::Flag;
using Number = std::optional<SignalNumber>;
using Form = SignalInfo::Form;
using Scale = SignalInfo::Scale;
using Clock = SignalInfo::Clock;

constexpr bool has(const CycleSample& sample, Flag flag) { return (sample.flags & flag) != 0; }
constexpr bool came_back(const CycleSample& sample) { return !has(sample, Flag::kFrameLost); }
/// The controller has worked with a reading of this cycle; without one its figures are those of an earlier one.
constexpr bool is_controlled(const CycleSample& sample) {
  return has(sample, Flag::kDcmActive) && has(sample, Flag::kReferenceValid);
}

constexpr bool is_learned(const CycleSample& sample) {
  return has(sample, Flag::kDcmActive) && is_told(sample, kLearnedUntold);
}

template <class T>
Number whole(T value) {
  return SignalNumber(static_cast<std::int64_t>(value));
}
template <class T>
Number whole_when(bool valid, T value) {
  return valid ? whole(value) : std::nullopt;
}

/// The names of MathWorks' EtherCAT Init block. Without distributed clocks both are zero, as there.
Number network_to_slave(const CycleSample& s) {
  if (has(s, Flag::kDeviationValid)) return whole(s.deviation_ored_ns);
  // Monitored, but not read in this cycle; or no clocks at all.
  return has(s, Flag::kReferenceValid) || !is_told(s, kStateUntold) ? std::nullopt : whole(0);
}
Number master_to_network(const CycleSample& s) {
  if (!is_told(s, kStateUntold) && !has(s, Flag::kDcmActive)) return std::nullopt;
  if (has(s, Flag::kReferenceValid)) return whole(s.dcm_error_ns);
  return has(s, Flag::kDcmActive) ? std::nullopt : whole(0);
}

using OfCycle = Number (*)(const CycleSample&);
using OfBus = std::optional<double> (*)(const Snapshot&);

constexpr SignalInfo cell(Signal id, const char* key, const char* name, const char* unit, OfCycle of_cycle) {
  return {
      id,           key,      name,    unit,   "host clock", "", SignalInfo::Scope::kBus, Form::kCell, Scale::kLinear,
      Clock::kNone, of_cycle, nullptr, nullptr};
}
constexpr SignalInfo every_cycle(Signal id, const char* key, const char* name, const char* unit, const char* source,
                                 Scale scale, Clock clock, OfCycle of_cycle) {
  return {id,    key,   name,     unit,    source, "", SignalInfo::Scope::kBus, Form::kCycles,
          scale, clock, of_cycle, nullptr, nullptr};
}
constexpr SignalInfo now_and_then(Signal id, const char* key, const char* name, const char* unit, const char* source,
                                  Scale scale, Clock clock, OfCycle of_cycle) {
  return {id,    key,   name,     unit,    source, "", SignalInfo::Scope::kBus, Form::kReadings,
          scale, clock, of_cycle, nullptr, nullptr};
}
constexpr SignalInfo held(Signal id, const char* key, const char* name, const char* unit, const char* source,
                          Scale scale, OfCycle of_cycle) {
  return {id,          key,   name,         unit,     source,  "",     SignalInfo::Scope::kBus,
          Form::kHeld, scale, Clock::kNone, of_cycle, nullptr, nullptr};
}
constexpr SignalInfo total(Signal id, const char* key, const char* name, const char* source, OfBus of_bus) {
  return {id,
          key,
          name,
          "",
          source,
          "going online",
          SignalInfo::Scope::kBus,
          Form::kHeld,
          Scale::kLinear,
          Clock::kNone,
          nullptr,
          of_bus,
          nullptr};
}

constexpr const char* kDcm = "master synchronisation (DCM), in the grid of the reference clock's SYNC0";
constexpr const char* kTimeDifference = "register 0x092C";
constexpr const char* kProcessData = "process data commands";

constexpr std::array kBusRows{
    cell(Signal::kCycle, "cycle", "Cycle", "", [](const CycleSample& s) { return whole(s.cycle); }),
    cell(Signal::kSendTime, "send_time_ns", "Send time", "ns", [](const CycleSample& s) { return whole(s.send_time); }),
    every_cycle(Signal::kLateness, "lateness_ns", "Send lateness", "ns", "host clock: send time less scheduled time",
                Scale::kSignedLog, Clock::kHost,
                [](const CycleSample& s) { return whole_when(is_told(s, kLatenessUntold), s.wake_lateness_ns); }),
    every_cycle(
        Signal::kRoundTrip, "round_trip_ns", "Round trip", "ns", "host clock", Scale::kLog, Clock::kHost,
        [](const CycleSample& s) { return whole_when(came_back(s) && is_told(s, kRoundTripUntold), s.round_trip_ns); }),
    cell(Signal::kReferenceTime, "reference_time_ns", "System time", "ns",
         [](const CycleSample& s) {
           return whole_when(has(s, Flag::kReferenceValid) && s.reference_time != 0, s.reference_time);
         }),
    every_cycle(Signal::kDcmError, "dcm_error_ns", "DCM error", "ns", kDcm, Scale::kSignedLog, Clock::kBoth,
                [](const CycleSample& s) { return whole_when(is_controlled(s), s.dcm_error_ns); }),
    every_cycle(Signal::kDcmErrorFiltered, "dcm_error_filtered_ns", "DCM error, filtered", "ns", kDcm,
                Scale::kSignedLog, Clock::kBoth,
                [](const CycleSample& s) { return whole_when(is_controlled(s), s.dcm_error_filtered_ns); }),
    every_cycle(Signal::kFrameError, "frame_error_ns", "DCM error with lateness", "ns",
                "DCM error and how late the frame was sent", Scale::kSignedLog, Clock::kBoth,
                [](const CycleSample& s) {
                  return whole_when(is_controlled(s) && is_told(s, kLatenessUntold),
                                    std::int64_t{s.dcm_error_ns} + s.wake_lateness_ns);
                }),
    every_cycle(
        Signal::kDrift, "drift_ppm", "Drift", "ppm", "host clock against reference clock", Scale::kLinear, Clock::kBoth,
        [](const CycleSample& s) { return is_controlled(s) ? Number(SignalNumber(s.drift_ppm)) : std::nullopt; }),
    every_cycle(Signal::kDcmAdjust, "dcm_adjust_ns", "Adjustment", "ns", kDcm, Scale::kSignedLog, Clock::kNone,
                [](const CycleSample& s) { return whole_when(has(s, Flag::kDcmActive), s.dcm_adjust_ns); }),
    every_cycle(
        Signal::kDeviation, "deviation_ns", "Largest deviation", "ns",
        "register 0x092C of the slaves that follow the reference clock", Scale::kLog, Clock::kSlaves,
        [](const CycleSample& s) { return whole_when(came_back(s) && has(s, Flag::kFollowersRead), s.deviation_ns); }),
    every_cycle(Signal::kDeviationOred, "deviation_ored_ns", "Deviation, or-ed (an upper estimate)", "ns",
                "register 0x092C of all clocks, or-ed on the wire", Scale::kLog, Clock::kSlaves,
                [](const CycleSample& s) { return whole_when(has(s, Flag::kDeviationValid), s.deviation_ored_ns); }),
    every_cycle(Signal::kNetworkToSlave, "NetworkToSubDeviceClkDiff_ns", "Network to slave", "ns", kTimeDifference,
                Scale::kLog, Clock::kSlaves, network_to_slave),
    every_cycle(Signal::kMasterToNetwork, "MdeviceToNetworkClkDiff_ns", "Master to network", "ns", kDcm,
                Scale::kSignedLog, Clock::kBoth, master_to_network),
    held(Signal::kWkcExpected, "wkc_expected", "Working counter, expected", "", kProcessData, Scale::kLinear,
         [](const CycleSample& s) {
           return whole_when(is_told(s, kFramesUntold) && is_told(s, kExpectedUntold), s.wkc_expected);
         }),
    held(Signal::kWkcReceived, "wkc_received", "Working counter, received", "", kProcessData, Scale::kLinear,
         [](const CycleSample& s) { return whole_when(came_back(s) && is_told(s, kFramesUntold), s.wkc_received); }),
    cell(Signal::kFrameLost, "frame_lost", "Frame lost", "",
         [](const CycleSample& s) { return whole_when(is_told(s, kFramesUntold), came_back(s) ? 0 : 1); }),
    held(Signal::kFramesLost, "frames_lost", "Frames lost in a cycle", "", "frames not back at their deadline",
         Scale::kLinear, [](const CycleSample& s) { return whole_when(is_told(s, kFramesUntold), s.frames_lost); }),
    now_and_then(Signal::kFrameLateBy, "frame_late_by_ns", "Frame late by", "ns", "host clock: back after its deadline",
                 Scale::kLog, Clock::kHost,
                 [](const CycleSample& s) { return whole_when(has(s, Flag::kFrameLate), s.late_by_ns); }),
    held(Signal::kSkippedCycles, "skipped_cycles", "Cycles left out before a cycle", "", "host clock", Scale::kLinear,
         [](const CycleSample& s) { return whole_when(is_told(s, kLatenessUntold), s.skipped_cycles); }),
    cell(Signal::kDcInSync, "dc_in_sync", "Slaves in sync", "",
         [](const CycleSample& s) {
           return whole_when(is_watched(s.slaves_sync), s.slaves_sync == SyncState::kInSync ? 1 : 0);
         }),
    cell(Signal::kDcmInSync, "dcm_in_sync", "Master in sync", "",
         [](const CycleSample& s) {
           return whole_when(has(s, Flag::kDcmActive), s.master_sync == SyncState::kInSync ? 1 : 0);
         }),
    held(Signal::kSlavesSync, "slaves_sync", "Slaves' synchronisation", "", "verdict on the slaves", Scale::kBand,
         [](const CycleSample& s) { return whole(s.slaves_sync); }),
    held(Signal::kMasterSync, "master_sync", "Master's synchronisation", "", "verdict on the master", Scale::kBand,
         [](const CycleSample& s) { return whole(s.master_sync); }),
    held(Signal::kMasterState, "master_state", "Master's state", "", "lowest AL status of all slaves", Scale::kBand,
         [](const CycleSample& s) { return whole_when(s.master_state != 0, s.master_state); }),
    cell(Signal::kSlave, "slave", "Slave that was read", "",
         [](const CycleSample& s) { return whole_when(s.slave_position >= 0, s.slave_position); }),
    cell(Signal::kSlaveReading, "slave_deviation_ns", "Its deviation", "ns",
         [](const CycleSample& s) { return whole_when(s.slave_position >= 0, s.slave_deviation_ns); }),
    cell(Signal::kSlaveFollows, "slave_follows", "It follows the reference clock", "",
         [](const CycleSample& s) { return whole_when(s.slave_position >= 0, has(s, Flag::kSlaveFollows) ? 1 : 0); }),
    cell(Signal::kSm2Slave, "sm2_slave", "Slave whose SM2 misses were read", "",
         [](const CycleSample& s) { return whole_when(s.sm2_position >= 0, s.sm2_position); }),
    cell(Signal::kSm2Reading, "sm2_missed", "Its SM2 misses", "",
         [](const CycleSample& s) { return whole_when(s.sm2_position >= 0, s.slave_sm2_missed); }),
    cell(Signal::kSm2IntegratorReading, "sm2_integrator", "Its fuse", "",
         [](const CycleSample& s) { return whole_when(s.sm2_position >= 0, s.slave_sm2_integrator); }),
    cell(Signal::kFlags, "flags", "Flags of the sample", "", [](const CycleSample& s) { return whole(s.flags); }),
    every_cycle(
        Signal::kDcmOutputSum, "dcm_output_sum_ns", "What the controller has learned, a cycle", "ns", kDcm,
        Scale::kSignedLog, Clock::kNone,
        [](const CycleSample& s) { return is_learned(s) ? Number(SignalNumber(s.dcm_output_sum_ns)) : std::nullopt; }),
    every_cycle(Signal::kDcmOutputTotal, "dcm_output_total_ns", "All adjustments", "ns", kDcm, Scale::kSignedLog,
                Clock::kNone, [](const CycleSample& s) { return whole_when(is_learned(s), s.dcm_output_total_ns); }),
    cell(Signal::kDcmErrorCode, "dcm_error_code", "DCM error code", "",
         [](const CycleSample& s) { return whole(s.dcm_error_code); }),
    cell(Signal::kSyncBase, "sync_base_ns", "Base of the SYNC grid", "ns",
         [](const CycleSample& s) { return whole_when(has(s, Flag::kSyncBaseValid), s.sync_base); }),
    cell(Signal::kWatchList, "watch_list", "List of the watched variables", "",
         [](const CycleSample& s) { return whole_when(s.watch_list != 0, s.watch_list); }),
    SignalInfo{Signal::kVariable, "variable", "Variable of the process image", "", "process image", "",
               SignalInfo::Scope::kVariable, Form::kWatched, Scale::kLinear, Clock::kNone, nullptr, nullptr, nullptr},
    every_cycle(Signal::kStampDoubt, "stamp_doubt_ns", "Doubt of the send stamp", "ns",
                "host clock: a frame that came back so much later than the quickest ones", Scale::kLog, Clock::kHost,
                [](const CycleSample& s) { return whole_when(s.stamp_doubt_ns >= 0, s.stamp_doubt_ns); }),
    cell(Signal::kStampedBy, "stamped_by", "Who stamped the frame", "",
         [](const CycleSample& s) {
           return whole_when(s.stamped_by != StampSource::kUntold, static_cast<int>(s.stamped_by));
         }),
    every_cycle(Signal::kExternalError, "external_error_ns", "Reference clock against external clock", "ns",
                "time stamps in the PDO of the bridge device (DCX)", Scale::kSignedLog, Clock::kNone,
                [](const CycleSample& s) {
                  return whole_when(s.external_error_ns != CycleSample::kNoExternalClock, s.external_error_ns);
                }),
    total(Signal::kLostFrames, "lost_frames_total", "Lost frames", "not back at their deadline, and not come since",
          [](const Snapshot& s) { return std::optional(static_cast<double>(s.lost_frames)); }),
    total(Signal::kLateFrames, "late_frames_total", "Late frames", "back after their deadline",
          [](const Snapshot& s) { return std::optional(static_cast<double>(s.late_frames)); }),
    total(Signal::kLeftOutCycles, "skipped_cycles_total", "Cycles left out", "the host came too late for them",
          [](const Snapshot& s) { return std::optional(static_cast<double>(s.skipped_cycles)); }),
    total(Signal::kWkcErrors, "wkc_errors_total", "Wrong working counters", kProcessData,
          [](const Snapshot& s) { return std::optional(static_cast<double>(s.wkc_errors)); }),
    total(Signal::kLateSends, "late_sends_total", "Frames too late for SYNC0", "DCM error with lateness",
          [](const Snapshot& s) { return std::optional(static_cast<double>(s.dcm.late_sends)); }),
};

float drawn(const Number& number) {
  if (!number) return std::numeric_limits<float>::quiet_NaN();
  if (const auto* const value = std::get_if<std::int64_t>(&*number))
    return static_cast<float>(static_cast<double>(*value));
  const auto* const real = std::get_if<float>(&*number);
  return real != nullptr ? *real : std::numeric_limits<float>::quiet_NaN();
}

/// One loop a row, in which its function is no call.
template <std::size_t row>
void values_of(std::span<const CycleSample> samples, float* out) {
  constexpr auto kOfCycle = kBusRows[row].of_cycle;
  for (const auto& sample : samples) *out++ = drawn(kOfCycle(sample));
}

constexpr auto kCycleValues = []<std::size_t... rows>(std::index_sequence<rows...>) {
  std::array<CycleValues, kSignalCount> table{};
  const auto put = [&table]<std::size_t row>() {
    if constexpr (kBusRows[row].of_cycle != nullptr)
      table[static_cast<std::size_t>(kBusRows[row].id)] = &values_of<row>;
  };
  (put.template operator()<rows>(), ...);
  return table;
}
(std::make_index_sequence<kBusRows.size()>{});

}  // namespace

void put_bus_signals(SignalTable& table) {
  for (const auto& row : kBusRows) put_signal(table, row);
}

CycleValues cycle_values(Signal signal) { return kCycleValues[static_cast<std::size_t>(signal)]; }

}  // namespace syncline
