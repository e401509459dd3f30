// SPDX-License-Identifier: Apache-2.0
#include "protocol/register_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "protocol/al_state.h"
#include "protocol/registers.h"
#include "support/bits.h"
#include "support/le_number.h"

namespace syncline::reg {
namespace {

using enum RegisterValue;
using Group = RegisterGroup;

constexpr std::string_view kPortKinds = "none|not configured|EBUS|MII";
constexpr std::string_view kLoops = "auto|auto close|always open|always closed";
constexpr std::string_view kLinks = "no link|link";
constexpr std::string_view kLoopStates = "open|closed";
constexpr std::string_view kUsers = "EtherCAT|PDI";

constexpr RegisterField kPortFields[] = {{0, 2, "Port 0", kPortKinds},
                                         {2, 2, "Port 1", kPortKinds},
                                         {4, 2, "Port 2", kPortKinds},
                                         {6, 2, "Port 3", kPortKinds}};
constexpr RegisterField kFeatureFields[] = {{0, 1, "FMMU operation", "bits|bytes"},
                                            {2, 1, "Distributed clocks"},
                                            {3, 1, "Width of distributed clocks", "32 bit|64 bit"},
                                            {4, 1, "Low jitter EBUS"},
                                            {5, 1, "Enhanced link detection EBUS"},
                                            {6, 1, "Enhanced link detection MII"},
                                            {7, 1, "Separate handling of FCS errors"},
                                            {8, 1, "Enhanced DC SYNC activation"},
                                            {9, 1, "LRW", "supported|not supported"},
                                            {10, 1, "BRW, APRW, FPRW", "supported|not supported"},
                                            {11, 1, "Fixed FMMU and SyncManager assignment"}};
constexpr RegisterField kDlControlFields[] = {{0, 1, "Forwarding rule", "all frames|EtherCAT only"},
                                              {1, 1, "Temporary use"},
                                              {8, 2, "Loop port 0", kLoops},
                                              {10, 2, "Loop port 1", kLoops},
                                              {12, 2, "Loop port 2", kLoops},
                                              {14, 2, "Loop port 3", kLoops},
                                              {16, 3, "RX FIFO size"},
                                              {24, 1, "Station alias addressing"}};
constexpr RegisterField kDlStatusFields[] = {
    {0, 1, "PDI operational, EEPROM loaded"}, {1, 1, "PDI watchdog", "expired|in time"},
    {2, 1, "Enhanced link detection"},        {4, 1, "Physical link port 0", kLinks},
    {5, 1, "Physical link port 1", kLinks},   {6, 1, "Physical link port 2", kLinks},
    {7, 1, "Physical link port 3", kLinks},   {8, 1, "Loop port 0", kLoopStates},
    {9, 1, "Communication port 0"},           {10, 1, "Loop port 1", kLoopStates},
    {11, 1, "Communication port 1"},          {12, 1, "Loop port 2", kLoopStates},
    {13, 1, "Communication port 2"},          {14, 1, "Loop port 3", kLoopStates},
    {15, 1, "Communication port 3"}};
constexpr std::string_view kAlStates = "-|INIT|PREOP|BOOT|SAFEOP|-|-|-|OP";
constexpr RegisterField kAlControlFields[] = {
    {0, 4, "Requested state", kAlStates}, {4, 1, "Error acknowledge"}, {5, 1, "Device identification requested"}};
constexpr RegisterField kAlStatusFields[] = {
    {0, 4, "State", kAlStates}, {4, 1, "Error indication"}, {5, 1, "Device identification loaded"}};
constexpr RegisterField kEscConfigurationFields[] = {{0, 1, "Device emulation"},
                                                     {1, 1, "Enhanced link detection"},
                                                     {2, 1, "DC SYNC out unit"},
                                                     {3, 1, "DC latch in unit"}};
constexpr RegisterField kSyncPinFields[] = {
    {0, 2, "SYNC0 output driver"}, {2, 1, "SYNC0/LATCH0", "LATCH0|SYNC0"}, {3, 1, "SYNC0 to AL event request"},
    {4, 2, "SYNC1 output driver"}, {6, 1, "SYNC1/LATCH1", "LATCH1|SYNC1"}, {7, 1, "SYNC1 to AL event request"}};
constexpr RegisterField kEcatEventFields[] = {
    {0, 1, "DC latch event"}, {2, 1, "DL status event"}, {3, 1, "AL status event"}, {4, 8, "SyncManagers 0 to 7"}};
constexpr RegisterField kAlEventFields[] = {{0, 1, "AL control event"},
                                            {1, 1, "DC latch event"},
                                            {2, 1, "SYNC0"},
                                            {3, 1, "SYNC1"},
                                            {4, 1, "SyncManager activation changed"},
                                            {5, 1, "EEPROM emulation"},
                                            {6, 1, "Process data watchdog expired"},
                                            {8, 16, "SyncManagers 0 to 15"}};
constexpr RegisterField kWatchdogStatusFields[] = {{0, 1, "Process data watchdog", "expired|in time or off"}};
constexpr RegisterField kSiiConfigurationFields[] = {{0, 1, "EEPROM offered to", kUsers}, {1, 1, "Taken by force"}};
constexpr RegisterField kSiiAccessFields[] = {{0, 1, "PDI has the EEPROM"}};
constexpr RegisterField kSiiControlFields[] = {{0, 1, "Write enable"},
                                               {5, 1, "Emulated by the PDI"},
                                               {6, 1, "Bytes a read", "4|8"},
                                               {7, 1, "Address bytes", "1|2"},
                                               {8, 3, "Command", "none|read|write|-|reload"},
                                               {11, 1, "Checksum error"},
                                               {12, 1, "Not loaded"},
                                               {13, 1, "Acknowledge error"},
                                               {14, 1, "Write enable error"},
                                               {15, 1, "Busy"}};
constexpr RegisterField kFmmuTypeFields[] = {{0, 1, "Read"}, {1, 1, "Write"}};
constexpr RegisterField kActiveFields[] = {{0, 1, "Active"}};
constexpr RegisterField kSmControlFields[] = {{0, 2, "Mode", "buffered|-|mailbox|-"},
                                              {2, 2, "Direction", "read (inputs)|write (outputs)|-|-"},
                                              {4, 1, "Interrupt in ECAT event request"},
                                              {5, 1, "Interrupt in AL event request"},
                                              {6, 1, "Watchdog trigger"}};
constexpr RegisterField kSmStatusFields[] = {{0, 1, "Write event"},           {1, 1, "Read event"},
                                             {3, 1, "Mailbox", "empty|full"}, {4, 2, "Buffer", "1|2|3|none written"},
                                             {6, 1, "Read buffer in use"},    {7, 1, "Write buffer in use"}};
constexpr RegisterField kSmActivateFields[] = {{0, 1, "Enabled"},
                                               {1, 1, "Repeat request"},
                                               {6, 1, "Latch event on EtherCAT access"},
                                               {7, 1, "Latch event on PDI access"}};
constexpr RegisterField kSmPdiFields[] = {{0, 1, "Deactivated by the PDI"}, {1, 1, "Repeat acknowledge"}};
constexpr RegisterField kCyclicFields[] = {
    {0, 1, "SYNC unit owned by", kUsers}, {4, 1, "Latch 0 owned by", kUsers}, {5, 1, "Latch 1 owned by", kUsers}};
constexpr RegisterField kActivationFields[] = {{0, 1, "Cyclic operation"},
                                               {1, 1, "SYNC0"},
                                               {2, 1, "SYNC1"},
                                               {3, 1, "Activation by the start time"},
                                               {4, 1, "Start time extended to 64 bit"},
                                               {5, 1, "Plausibility check of the start time"},
                                               {6, 1, "Near future", "half of the range|2.1 s"},
                                               {7, 1, "Debug pulse"}};
constexpr RegisterField kActivationStatusFields[] = {
    {0, 1, "First SYNC0 pending"}, {1, 1, "First SYNC1 pending"}, {2, 1, "Start time not in the near future"}};
constexpr RegisterField kLatchControlFields[] = {{0, 1, "Positive edge", "continuous|single"},
                                                 {1, 1, "Negative edge", "continuous|single"}};
constexpr RegisterField kLatchStatusFields[] = {
    {0, 1, "Event on the positive edge"}, {1, 1, "Event on the negative edge"}, {2, 1, "Pin"}};

struct LayoutRow {
  std::uint16_t address;
  std::uint8_t length;
  Group group;
  RegisterValue value = kHex;
  std::span<const RegisterField> fields{};
};

constexpr LayoutRow kLayoutRows[] = {
    {kType, 1, Group::kEsc},
    {kRevision, 1, Group::kEsc},
    {kBuild, 2, Group::kEsc},
    {kFmmuCount, 1, Group::kEsc, kNumber},
    {kSyncManagerCount, 1, Group::kEsc, kNumber},
    {kRamSize, 1, Group::kEsc, kNumber},
    {kPortDescriptor, 1, Group::kEsc, kHex, kPortFields},
    {kFeatures, 2, Group::kEsc, kHex, kFeatureFields},
    {kStationAddress, 2, Group::kAddresses, kNumber},
    {kStationAlias, 2, Group::kAddresses, kNumber},
    {kDlControl, 4, Group::kDataLink, kHex, kDlControlFields},
    {0x0108, 2, Group::kDataLink},
    {kDlStatus, 2, Group::kDataLink, kHex, kDlStatusFields},
    {kAlControl, 2, Group::kApplicationLayer, kAlState, kAlControlFields},
    {kAlStatus, 2, Group::kApplicationLayer, kAlState, kAlStatusFields},
    {kAlStatusCode, 2, Group::kApplicationLayer, kStateCode},
    {kPdiControl, 1, Group::kApplicationLayer},
    {kEscConfiguration, 1, Group::kApplicationLayer, kHex, kEscConfigurationFields},
    {kPdiConfiguration, 1, Group::kApplicationLayer},
    {kSyncLatchConfiguration, 1, Group::kApplicationLayer, kHex, kSyncPinFields},
    {kEcatEventMask, 2, Group::kEvents, kHex, kEcatEventFields},
    {kAlEventMask, 4, Group::kEvents, kHex, kAlEventFields},
    {kEcatEventRequest, 2, Group::kEvents, kHex, kEcatEventFields},
    {kAlEventRequest, 4, Group::kEvents, kHex, kAlEventFields},
    {kWatchdogDivider, 2, Group::kWatchdogs, kNumber},
    {kWatchdogPdi, 2, Group::kWatchdogs, kNumber},
    {kWatchdogProcessData, 2, Group::kWatchdogs, kNumber},
    {kWatchdogStatus, 2, Group::kWatchdogs, kHex, kWatchdogStatusFields},
    {kWatchdogCounterProcessData, 1, Group::kWatchdogs, kNumber},
    {kWatchdogCounterPdi, 1, Group::kWatchdogs, kNumber},
    {kSiiConfiguration, 1, Group::kEeprom, kHex, kSiiConfigurationFields},
    {kSiiPdiAccess, 1, Group::kEeprom, kHex, kSiiAccessFields},
    {kSiiControl, 2, Group::kEeprom, kHex, kSiiControlFields},
    {kSiiAddress, 4, Group::kEeprom},
    {kSiiData, 8, Group::kEeprom},
    {kReceiveTimePort0, 4, Group::kClock, kNanoseconds},
    {kReceiveTimePort1, 4, Group::kClock, kNanoseconds},
    {kReceiveTimePort2, 4, Group::kClock, kNanoseconds},
    {kReceiveTimePort3, 4, Group::kClock, kNanoseconds},
    {kSystemTime, 8, Group::kClock, kNanoseconds},
    {kReceiveTimeProcessingUnit, 8, Group::kClock, kNanoseconds},
    {kSystemTimeOffset, 8, Group::kClock, kSignedNanoseconds},
    {kSystemTimeDelay, 4, Group::kClock, kNanoseconds},
    {kSystemTimeDifference, 4, Group::kClock, kSignMagnitudeNanoseconds},
    {kSpeedCounterStart, 2, Group::kClock, kNumber},
    {kSpeedCounterDiff, 2, Group::kClock, kSignedNumber},
    {kFilterDepthDifference, 1, Group::kClock, kNumber},
    {kFilterDepthSpeedCounter, 1, Group::kClock, kNumber},
    {kReceiveTimeLatchMode, 1, Group::kClock},
    {kCyclicUnitControl, 1, Group::kSyncSignals, kHex, kCyclicFields},
    {kActivation, 1, Group::kSyncSignals, kHex, kActivationFields},
    {kPulseLength, 2, Group::kSyncSignals, kTenNanoseconds},
    {kActivationStatus, 1, Group::kSyncSignals, kHex, kActivationStatusFields},
    {kSync0Status, 1, Group::kSyncSignals},
    {kSync1Status, 1, Group::kSyncSignals},
    {kStartTimeCyclicOperation, 8, Group::kSyncSignals, kNanoseconds},
    {kNextSync1Pulse, 8, Group::kSyncSignals, kNanoseconds},
    {kSync0CycleTime, 4, Group::kSyncSignals, kNanoseconds},
    {kSync1CycleTime, 4, Group::kSyncSignals, kNanoseconds},
    {kLatch0Control, 1, Group::kLatch, kHex, kLatchControlFields},
    {kLatch1Control, 1, Group::kLatch, kHex, kLatchControlFields},
    {kLatch0Status, 1, Group::kLatch, kHex, kLatchStatusFields},
    {kLatch1Status, 1, Group::kLatch, kHex, kLatchStatusFields},
    {kLatch0PositiveEdge, 8, Group::kLatch, kNanoseconds},
    {kLatch0NegativeEdge, 8, Group::kLatch, kNanoseconds},
    {kLatch1PositiveEdge, 8, Group::kLatch, kNanoseconds},
    {kLatch1NegativeEdge, 8, Group::kLatch, kNanoseconds},
    {kEcatBufferChangeTime, 4, Group::kClock, kNanoseconds},
};

struct PartRow {
  std::uint8_t offset, length;
  std::string_view name;
  RegisterValue value = kHex;
  std::span<const RegisterField> fields{};
};
constexpr PartRow kFmmuParts[] = {{0, 4, "logical start address"},        {4, 2, "length", kNumber},
                                  {6, 1, "logical start bit", kNumber},   {7, 1, "logical stop bit", kNumber},
                                  {8, 2, "physical start address"},       {10, 1, "physical start bit", kNumber},
                                  {11, 1, "type", kHex, kFmmuTypeFields}, {12, 1, "activation", kHex, kActiveFields}};
constexpr PartRow kSyncManagerParts[] = {{0, 2, "physical start address"},
                                         {2, 2, "length", kNumber},
                                         {4, 1, "control", kHex, kSmControlFields},
                                         {5, 1, "status", kHex, kSmStatusFields},
                                         {6, 1, "activation", kHex, kSmActivateFields},
                                         {7, 1, "PDI control", kHex, kSmPdiFields}};

void append_parts(std::vector<RegisterLayout>& all, std::uint16_t base, Group group, std::span<const PartRow> parts) {
  const auto owner = name(base);
  for (const auto& part : parts) {
    all.push_back({static_cast<std::uint16_t>(base + part.offset), part.length, group,
                   fmt::format("{} {}", owner, part.name), part.value, part.fields});
  }
}

/// Counters of ports: a byte each.
void append_counters(std::vector<RegisterLayout>& all) {
  const auto counter = [&](unsigned address, std::string text) {
    all.push_back({static_cast<std::uint16_t>(address), 1, Group::kErrorCounters, std::move(text), kNumber});
  };
  for (unsigned port = 0; port < 4; ++port) {
    counter(kRxErrorCounter + 2 * port, fmt::format("Invalid frames port {}", port));
    counter(kRxErrorCounter + 2 * port + 1, fmt::format("RX errors port {}", port));
    counter(kForwardedErrorCounter + port, fmt::format("Forwarded RX errors port {}", port));
    counter(kLostLinkCounter + port, fmt::format("Lost links port {}", port));
  }
  for (const auto address : {kProcessingUnitErrorCounter, kPdiErrorCounter})
    counter(address, std::string(name(address)));
}

}  // namespace

std::string_view register_group_name(RegisterGroup group) {
  constexpr std::array<std::string_view, kRegisterGroups> kNames{
      "ESC",    "Addresses", "Data link",    "Application layer", "Events",           "Error counters", "Watchdogs",
      "EEPROM", "FMMUs",     "SyncManagers", "DC: clock",         "DC: SYNC signals", "DC: latch"};
  return kNames.at(static_cast<std::size_t>(group));
}

std::vector<RegisterLayout> register_layouts(unsigned fmmus, unsigned sync_managers) {
  std::vector<RegisterLayout> all;
  for (const auto& row : kLayoutRows) {
    RegisterLayout one{row.address, row.length, row.group, std::string(name(row.address)), row.value, row.fields};
    // Reading the time of an edge gives the latch free for the next one (data sheet II, 2.17).
    one.reading_matters = row.address >= kLatch0PositiveEdge && row.address < kEcatBufferChangeTime;
    all.push_back(std::move(one));
  }
  append_counters(all);
  for (unsigned n = 0; n < std::min(fmmus, 16U); ++n) append_parts(all, fmmu(n), Group::kFmmus, kFmmuParts);
  for (unsigned n = 0; n < std::min(sync_managers, 16U); ++n)
    append_parts(all, sync_manager(n), Group::kSyncManagers, kSyncManagerParts);
  std::ranges::sort(all, {}, &RegisterLayout::address);
  return all;
}

std::string register_text(const RegisterLayout& layout, std::span<const std::uint8_t> bytes) {
  const auto value = le_number(bytes);
  switch (layout.value) {
    case kHex:
      return {};
    case kNumber:
      return fmt::format("{}", value);
    case kSignedNumber:
      return fmt::format("{}", le_signed_number(bytes));
    case kNanoseconds:
      return fmt::format("{} ns", value);
    case kSignedNanoseconds:
      return fmt::format("{} ns", le_signed_number(bytes));
    case kSignMagnitudeNanoseconds:
      return fmt::format("{}{} ns", (value & 0x8000'0000U) != 0 ? "-" : "", value & 0x7FFF'FFFFU);
    case kTenNanoseconds:
      return fmt::format("{} ns", 10 * value);
    case kAlState:
      return fmt::format("{}{}", al_state_name(al_state_of(static_cast<std::uint16_t>(value))),
                         (value & kAlErrorFlag) != 0 ? " + ERR" : "");
    case kStateCode:
      return std::string(al_status_code_text(static_cast<std::uint16_t>(value)).meaning);
  }
  return {};
}

std::string field_text(const RegisterField& field, std::span<const std::uint8_t> bytes) {
  const auto value = (le_number(bytes) >> field.bit) & low_bits(field.width);
  if (field.words.empty()) return field.width > 1 ? fmt::format("{}", value) : value != 0 ? "yes" : "no";
  auto rest = field.words;
  for (std::uint64_t i = 0; i < value; ++i) {
    const auto next = rest.find('|');
    if (next == std::string_view::npos) return fmt::format("{}", value);
    rest.remove_prefix(next + 1);
  }
  return std::string(rest.substr(0, rest.find('|')));
}

std::vector<RegisterRange> ranges_of(std::span<const RegisterLayout* const> layouts) {
  constexpr unsigned kBlock = 16;
  std::vector<RegisterRange> all;
  for (const auto* one : layouts) {
    const auto end = static_cast<unsigned>(one->address) + one->length;
    const bool together = !all.empty() && all.back().address / kBlock == one->address / kBlock && !one->reading_matters;
    if (together) {
      auto& last = all.back();
      last.length = static_cast<std::uint16_t>(std::max<unsigned>(end - last.address, last.length));
    } else {
      all.push_back({one->address, one->length});
    }
  }
  return all;
}

}  // namespace syncline::reg
