// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

/// The parts of the table of settings, one file each.
namespace syncline::settings {

struct Setting;

[[nodiscard]] std::vector<Setting> master_rows();        // general, recovery, real time
[[nodiscard]] std::vector<Setting> dc_rows();            // clocks of the bus
[[nodiscard]] std::vector<Setting> dcm_rows();           // how master and reference clock are brought together
[[nodiscard]] std::vector<Setting> image_rows();         // network, process image, tasks, Sync Units
[[nodiscard]] std::vector<Setting> slave_rows();         // name, address, place, identity check
[[nodiscard]] std::vector<Setting> slave_dc_rows();      // operation mode, SYNC0, SYNC1
[[nodiscard]] std::vector<Setting> slave_option_rows();  // optional, further checks, watchdogs, time-outs
[[nodiscard]] std::vector<Setting> mailbox_rows();       // mailbox, EoE, AoE, SoE, Sync Unit of a slave
[[nodiscard]] std::vector<Setting> sync_rows();          // synchronisation objects, gateways, output pins
[[nodiscard]] std::vector<Setting> module_rows();        // modules, oversampling
[[nodiscard]] std::vector<Setting> pdo_rows();           // assignment and mapping
[[nodiscard]] std::vector<Setting> startup_rows();
[[nodiscard]] std::vector<Setting> message_rows();      // start-up messages of AoE, EoE, FoE, VoE
[[nodiscard]] std::vector<Setting> own_command_rows();  // register commands of slaves and master
[[nodiscard]] std::vector<Setting> variable_rows();

}  // namespace syncline::settings
