// SPDX-License-Identifier: Apache-2.0
#include "app/composition/slave_eeprom.h"

#include <fmt/format.h>

#include "app/composition/whole_file.h"

namespace syncline {
namespace {

/// Names the slave in errors that know only that there is one.
Error with_slave(Error error, std::uint16_t position) {
  if (error.code == ErrorCode::kSii) error.subject = fmt::format("slave {}", position);
  return error;
}

template <class Work>
auto with_slave_of(const EepromRequest& request, Work work) -> decltype(work(std::declval<Bus&>(), std::declval<SlaveAddress>())) {
  auto opened = OpenBus::open_for_slave(request.link, request.position, request.cancel);
  if (!opened) return tl::unexpected(opened.error());
  auto& bus = (*opened)->bus();
  auto result = work(bus, SlaveAddress::at_position(request.position));
  if (!result) return tl::unexpected(with_slave(result.error(), request.position));
  return result;
}

}  // namespace

Result<std::size_t> save_eeprom(const EepromRequest& request, const std::string& path) {
  const auto bytes = with_slave_of(request, [](Bus& bus, const SlaveAddress& slave) { return read_eeprom(bus, slave); });
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto status = write_whole_file(path, *bytes); !status) return tl::unexpected(status.error());
  return bytes->size();
}

Result<SiiWriteReport> load_eeprom(const EepromRequest& request, const std::string& path) {
  const auto image = read_whole_file(path);
  if (!image) return tl::unexpected(image.error());
  return with_slave_of(request, [&](Bus& bus, const SlaveAddress& slave) { return write_eeprom(bus, slave, *image); });
}

Result<SiiWriteReport> set_eeprom_alias(const EepromRequest& request, std::uint16_t alias) {
  return with_slave_of(request, [&](Bus& bus, const SlaveAddress& slave) { return write_alias(bus, slave, alias); });
}

}  // namespace syncline
