// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "families/device_family.h"
#include "families/family_tables.h"

namespace syncline::families {
namespace {

// AN.MTN.01: Yaskawa America, "EtherCAT Master Architecture", March 2015. SIEP C710812 02: Sigma-X, EtherCAT (CoE)
// communications. SIEP S800001: the same of Sigma-7.
constexpr std::uint32_t kYaskawaVendor = 0x0539;

constexpr std::array kAlarms{Alarm{0x0A12, "A.A12", "EtherCAT Outputs Data Synchronization Error"}};

constexpr std::array<std::uint16_t, 2> kSigmaSyncTypes{0, 2};

constexpr std::array kSigmaModes{
    ModeNeedsDc{7, false, "Interpolated position mode 1 needs SYNC0; only its mode 2 works without"},
    ModeNeedsDc{8, true, "Cyclic synchronous position mode is executed with SYNC0 only"},
    ModeNeedsDc{9, true, "Cyclic synchronous velocity mode is executed with SYNC0 only"},
    ModeNeedsDc{10, true, "Cyclic synchronous torque mode is executed with SYNC0 only"},
};

/// What all CoE drives of the vendor have in common.
constexpr Family sigma(std::string_view id, std::string_view name, Match match, CycleLimits cycle) {
  Family family;
  family.id = id;
  family.name = name;
  family.devices = "drives";
  family.match = match;
  family.behaviour = "servo-y";
  family.cycle = cycle;
  // 7.2: 9 is the third missed event in a row, 15 the fifth; 0x603F has the alarm's number.
  family.error_limit = ErrorLimit{9, 15, 0x001A, 0x0A12, "Yaskawa AN.MTN.01, 7.2"};
  family.alarms = {kAlarms, "Yaskawa AN.MTN.01, 7.2"};
  // 7.3: 0x1C32:01 only tells what 0x0980 makes of it.
  family.sync_types = {
      kSigmaSyncTypes, kSigmaSyncTypes, 0, 0, false, true, "Yaskawa AN.MTN.01, 7.3; SIEP C710812 02, object 1C32h"};
  family.modes_need_dc = {kSigmaModes, "Yaskawa AN.MTN.01, 3.1 and 3.2"};
  family.objects = {16, "Yaskawa AN.MTN.01, 8"};
  return family;
}

constexpr CycleLimits kSigma5Cycle{125 * kMicrosecond, 125 * kMicrosecond, {},
                                   125 * kMicrosecond, 4 * kMillisecond,   "Yaskawa AN.MTN.01, 6 and 7.3"};
constexpr CycleLimits kSigma7Cycle{125 * kMicrosecond, 125 * kMicrosecond, {},
                                   125 * kMicrosecond, 4 * kMillisecond,   "Yaskawa SIEP S800001, DC cycles"};
constexpr CycleLimits kSigmaXCycle{62'500, 62'500, {}, 62'500, 4 * kMillisecond, "Yaskawa SIEP C710812, DC cycles"};
/// Of a product code that is not in the list: the newer drives take more than the older ones.
constexpr CycleLimits kAnySigmaCycle{62'500, 125 * kMicrosecond, "only Sigma-X drives take it",
                                     62'500, 4 * kMillisecond,   "Yaskawa AN.MTN.01, 6; SIEP C710812"};

/// 7.3 has the missed events at 0x0C, "Resets to 0 when EtherCAT state changes out of Operational state".
constexpr Family sigma_5() {
  Family family =
      sigma("yaskawa-sigma-5", "Yaskawa Sigma-5", {kYaskawaVendor, 0x0220'0001, 0x0220'00FF, "SGDV"}, kSigma5Cycle);
  family.counters = SyncCounters{0x0C, 0x0B, 0x0D, true, "Yaskawa AN.MTN.01, 7.3"};
  return family;
}

/// 0x1C32:11 (decimal) counts missed events; there is no counter of exceeded cycles or of a short shift.
constexpr Family sigma_x() {
  Family family =
      sigma("yaskawa-sigma-x", "Yaskawa Sigma-X", {kYaskawaVendor, 0x0220'0900, 0x0220'09FF, "SGDX"}, kSigmaXCycle);
  family.counters = SyncCounters{0x0B, 0, 0, false, "Yaskawa SIEP C710812 02, objects 1C32h and 1C33h"};
  family.times = LocalTimes{62'500, 0, "Yaskawa SIEP C710812 02, object 1C32h:06"};
  return family;
}

/// Sources disagree about the places of the counters of Sigma-7, so none are given: the object's own words decide.
constexpr std::array kYaskawaFamilies{
    sigma_5(),
    sigma("yaskawa-sigma-7", "Yaskawa Sigma-7", {kYaskawaVendor, 0x0220'0300, 0x0220'04FF, "SGD7"}, kSigma7Cycle),
    sigma_x(),
    sigma("yaskawa-sigma", "Yaskawa Sigma", {kYaskawaVendor, 0x0220'0000, 0x0220'FFFF, "SGD"}, kAnySigmaCycle),
};

}  // namespace

std::span<const Family> yaskawa_families() { return kYaskawaFamilies; }

}  // namespace syncline::families
