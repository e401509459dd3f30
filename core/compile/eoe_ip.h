// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// "Set IP parameter" of Ethernet over EtherCAT (ETG.1000.6, 5.7.4): flags of 4 bytes, then MAC, address, mask, gateway
/// and DNS server (each of the four least significant byte first) and a name of 32 bytes.
namespace syncline {

struct EoeSlaveSettings;

/// Behind the EoE header: always 58 bytes, as tools write them, with each parameter in its own place. Slaves differ in
/// whether a parameter that is not announced takes room, so that none is left out in front of one that is: the MAC is
/// then one made of the station address (02:01:05:20:hi:lo, as TwinCAT does), addresses are 0. Empty when nothing is
/// set.
[[nodiscard]] std::vector<std::uint8_t> encode_ip_parameters(const EoeSlaveSettings& eoe,
                                                             std::uint16_t station_address);

/// What such a command sets, with or without the EoE header in front, in either layout; a MAC made of the station
/// address is none. Nothing when it is another command.
[[nodiscard]] std::optional<EoeSlaveSettings> decode_ip_parameters(std::span<const std::uint8_t> data,
                                                                   std::uint16_t station_address);

}  // namespace syncline
