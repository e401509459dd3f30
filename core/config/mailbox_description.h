// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/al_state.h"

/// Which mailbox protocols a device speaks, and what its ESI wants to be sent at state transitions.
namespace syncline {

/// A CoE object written at a transition: from the ESI, or the user's own start-up list.
struct StartupCommand {
  std::vector<Transition> transitions{Transition::kPS};
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::vector<std::uint8_t> data;
  bool complete_access = false;
  bool fixed = false;
  bool enabled = true;
  std::uint32_t timeout_ms = 0;  // 0 = the master's default
  std::string comment;
  bool adapt_automatically = false;    // Data@AdaptAutomatically: the configurator writes its own value, e.g. 0x1C32:02
  bool overwritten_by_module = false;  // a modular configurator leaves it out, a module brings it
  bool depend_on_slot = false;         // in modules: SlotIndexIncrement is added to `index` for each slot
  bool depend_on_slot_group = false;
  bool operator==(const StartupCommand&) const = default;
};

/// AoE or EoE service sent at a transition.
struct MailboxCommand {
  std::vector<Transition> transitions{};
  int type = 0;                      // EoE: number of the service
  std::vector<std::uint8_t> data{};  // without mailbox header (EoE: without EoE header too)
  std::string comment{};
  bool operator==(const MailboxCommand&) const = default;
};

/// SoE IDN written at a transition: from the ESI, or the user's own.
struct SoeCommand {
  std::vector<Transition> transitions{Transition::kPS};
  std::uint8_t drive = 0;  // ESI: Chn, 0..7
  std::uint16_t idn = 0;   // bit 15: P, bits 14..12: parameter set, bits 11..0: block number
  std::vector<std::uint8_t> data{};
  bool fixed = false;
  bool enabled = true;
  std::uint32_t timeout_ms = 0;  // 0 = the master's default
  std::string comment{};
  bool operator==(const SoeCommand&) const = default;
};

struct AoeDescription {
  bool ads_router = false;
  bool generate_own_net_id = false;
  bool initialize_own_net_id = false;
  std::vector<MailboxCommand> init_commands{};
  bool operator==(const AoeDescription&) const = default;
};

struct EoeDescription {
  bool ip = false, mac = false;  // wants an address from the master
  bool time_stamp = false;
  std::vector<MailboxCommand> init_commands{};
  bool operator==(const EoeDescription&) const = default;
};

struct SoeDescription {
  std::optional<std::uint8_t> channel_count{};
  bool drive_follows_bit3 = false;
  std::vector<SoeCommand> init_commands{};
  bool operator==(const SoeDescription&) const = default;
};

struct CoeDescription {
  bool sdo_info = false;
  bool pdo_assign = false;
  bool pdo_config = false;
  bool pdo_upload = false;
  bool complete_access = false;
  bool segmented_sdo = false;
  std::vector<StartupCommand> init_commands;
  bool diag_history = false;  // 0x10F3
  bool module_od = false;     // of a module: its objects are in the device's dictionary
  std::optional<std::uint16_t> ds402_channels{};
  std::string eds_file{};
  bool operator==(const CoeDescription&) const = default;
};

struct MailboxDescription {
  bool data_link_layer = false;
  bool aoe = false, eoe = false, foe = false, soe = false, voe = false;
  std::optional<CoeDescription> coe;
  std::uint32_t request_timeout_ms = 100;
  std::uint32_t response_timeout_ms = 2000;
  bool real_time_mode = false;
  AoeDescription aoe_options{};  // of no meaning unless `aoe`, and so on
  EoeDescription eoe_options{};
  SoeDescription soe_options{};
  bool operator==(const MailboxDescription&) const = default;
};

}  // namespace syncline
