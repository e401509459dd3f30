// SPDX-License-Identifier: Apache-2.0
#include "master/startup/bus_survey.h"

#include <fmt/format.h>

#include <array>

#include "config/network_config.h"
#include "master/exchange/bus.h"
#include "master/exchange/slave_name.h"
#include "master/scan/bus_match.h"
#include "master/sii/sii_access.h"
#include "protocol/registers.h"
#include "reasons/because.h"

namespace syncline {
namespace {

constexpr std::uint16_t kIdentityWord = 0x08, kRevisionWord = 0x0C;

Status read_identities(Bus& bus, const std::vector<std::uint16_t>& positions, std::vector<FoundDevice>& devices) {
  if (positions.empty()) return {};
  std::vector<SlaveAddress> addresses;
  for (const auto position : positions) addresses.push_back(SlaveAddress::at_position(position));
  SiiAccess sii(bus, std::move(addresses), {.take_ownership = true, .broadcast = false});
  std::vector<SiiRequest> ids(positions.size()), revisions(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    ids[i].slave = revisions[i].slave = i;
    ids[i].word = kIdentityWord;
    revisions[i].word = kRevisionWord;
  }
  auto status = sii.open().and_then([&] { return sii.read(ids); }).and_then([&] { return sii.read(revisions); });
  if (auto closed = sii.close(); status) status = std::move(closed);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (ids[i].error || revisions[i].error) continue;
    const std::span<const std::uint8_t> id(ids[i].data), revision(revisions[i].data);
    devices[positions[i]].identity = {load_le<std::uint32_t>(id), load_le<std::uint32_t>(id.subspan(4)),
                                      load_le<std::uint32_t>(revision), load_le<std::uint32_t>(revision.subspan(4))};
  }
  return status;
}

/// Where a missing slave should be, by its neighbours.
Reason place_of(const NetworkConfig& config, std::size_t slave) {
  const auto& previous = config.slaves[slave].previous;
  if (!previous || previous->position >= config.slaves.size()) {
    return slave == 0 ? because("it should be the first on the bus")
                      : because("it should follow {slave}", slave_name(config, slave - 1));
  }
  return because("it should hang at port {port} of {slave}", static_cast<char>('A' + (previous->port & 3)),
                 slave_name(config, previous->position));
}

}  // namespace

Result<std::vector<FoundDevice>> survey_bus(Bus& bus, std::uint16_t count,
                                            const std::function<bool(std::uint16_t)>& known) {
  std::vector<FoundDevice> devices(count);
  std::vector<std::array<std::uint8_t, 4>> bytes(count);  // station address and alias
  std::vector<Datagram> reads;
  for (std::uint16_t position = 0; position < count; ++position) {
    reads.push_back(SlaveAddress::at_position(position).read(reg::kStationAddress, bytes[position]));
  }
  if (auto status = bus.transact(reads); !status) return tl::unexpected(status.error());
  std::vector<std::uint16_t> unknown;
  for (std::uint16_t position = 0; position < count; ++position) {
    devices[position].station_address = load_le<std::uint16_t>(bytes[position]);
    devices[position].alias = load_le<std::uint16_t>(std::span(bytes[position]).subspan(2));
    if (!known || !known(devices[position].station_address)) unknown.push_back(position);
  }
  if (auto status = read_identities(bus, unknown, devices); !status) return tl::unexpected(status.error());
  return devices;
}

WantedDevice wanted_device(const NetworkConfig& config, std::size_t index) {
  const auto& slave = config.slaves[index];
  WantedDevice wanted{slave.identity, slave.station_address, slave.alias};
  if (const auto head = config.hot_connect_head(index)) {
    wanted.optional = true;
    if (*head != index) wanted.follows = static_cast<std::uint16_t>(index - 1);
    if (*head == index) wanted.alias = slave.hot_connect->alias().value_or(0);
  }
  // The configuration says by its init commands whether the revision matters: a check asks for that word.
  for (const auto& command : slave.init_cmds) {
    if (command.ado == reg::kSiiControl && command.data.size() >= 4 &&
        load_le<std::uint16_t>(std::span(command.data).subspan(2)) == kRevisionWord) {
      wanted.check_revision = true;
    }
  }
  return wanted;
}

std::vector<Error> explain(const BusMatch& match, const NetworkConfig& config, const std::vector<FoundDevice>& found) {
  std::vector<Error> errors;
  for (const auto& [first, second] : match.swapped) {
    errors.push_back(
        {ErrorCode::kSlavesSwapped, slave_name(config, first), Reason::verbatim(slave_name(config, second))});
  }
  for (const auto slave : match.wrong) {
    errors.push_back({ErrorCode::kIdentityMismatch, slave_name(config, slave),
                      because("expected {wanted}, found {found}", to_string(config.slaves[slave].identity),
                              to_string(found[slave].identity))});
  }
  for (const auto slave : match.missing) {
    errors.push_back({ErrorCode::kSlaveMissing, slave_name(config, slave), place_of(config, slave)});
  }
  for (const auto position : match.extra) {
    errors.push_back({ErrorCode::kSlaveExtra, to_string(found[position].identity),
                      because("it is at position {position}", position)});
  }
  return errors;
}

}  // namespace syncline
