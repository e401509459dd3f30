// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "families/device_family.h"
#include "families/family_tables.h"

namespace syncline::families {
namespace {

// Text: Beckhoff, documentation of the EL6751, "Synchronization". ESI: Beckhoff EL67xx.xml, revisions 0x0011 to 0x0016.
// The text has exceeded cycles at 0x0B and the bus cycle once at 0x1C32:05; the ESI has 0x0C, and 0x1C32:02 writable.
constexpr std::array<std::uint16_t, 3> kOutputTypes{0, 1, 2};
constexpr std::array<std::uint16_t, 4> kInputTypes{0, 1, 2, 0x22};

constexpr CanGateway kGateway{
    .can_cycle = {0xF800, 0x04},
    .told_cycle = {0x1C32, 0x02},
    .tx_pdo_delay = {0xF800, 0x0E},
    .input_shift = {0x1C33, 0x03},
    .node_states = 0xF102,
    .node_late = 0x28,
    .sync1_jitter = 500,
    .source = "Beckhoff EL6751, Synchronization; ESI of the EL6751, 0xF800 and 0x1C33",
};

constexpr Family el6751() {
  Family family;
  family.id = "beckhoff-el6751";
  family.name = "EL6751";
  family.devices = "gateways";
  family.match = {0x0002, 0x1A5F'3052, 0x1A5F'3052, {}};
  family.behaviour = "can-gateway";
  family.counters = SyncCounters{0x0B, 0x0C, 0x0D, false, "ESI of the EL6751, 0x1C32 and 0x1C33"};
  family.gateway = kGateway;
  family.sync_types = {kOutputTypes, kInputTypes, 1, 0x22, true, true, "ESI of the EL6751, 0x1C32 and 0x1C33"};
  return family;
}

constexpr std::array kBeckhoffFamilies{el6751()};

}  // namespace

std::span<const Family> beckhoff_families() { return kBeckhoffFamilies; }

}  // namespace syncline::families
