// SPDX-License-Identifier: Apache-2.0
#include "app/composition/slave_eeprom.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "master/bus_scanner.h"

namespace syncline {
namespace {

/// Names the slave in errors that know only that there is one.
Error with_slave(Error error, std::uint16_t position) {
  if (error.code == ErrorCode::kSii) error.subject = fmt::format("slave {}", position);
  return error;
}

template <class Work>
auto with_slave_of(const EepromRequest& request, Work work) -> decltype(work(std::declval<Bus&>(), std::declval<SlaveAddress>())) {
  auto opened = OpenBus::open(request.link, request.cancel);
  if (!opened) return tl::unexpected(opened.error());
  auto& bus = (*opened)->bus();
  const auto count = count_slaves(bus);
  if (!count) return tl::unexpected(count.error());
  if (request.position >= *count) {
    return fail(ErrorCode::kNoResponse, fmt::format("slave {} ({} slaves are there)", request.position, *count));
  }
  auto result = work(bus, SlaveAddress::at_position(request.position));
  if (!result) return tl::unexpected(with_slave(result.error(), request.position));
  return result;
}

/// A file that is there is whole: it gets its name when everything is in it.
Status write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  const auto part = path + ".part";
  {
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) return fail({.code = ErrorCode::kFileNotWritable, .file = path});
  }
  std::error_code error;
  std::filesystem::rename(part, path, error);
  if (error) return fail({.code = ErrorCode::kFileNotWritable, .detail = error.message(), .file = path});
  return {};
}

}  // namespace

Result<std::size_t> save_eeprom(const EepromRequest& request, const std::string& path) {
  const auto bytes = with_slave_of(request, [](Bus& bus, const SlaveAddress& slave) { return read_eeprom(bus, slave); });
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto status = write_file(path, *bytes); !status) return tl::unexpected(status.error());
  return bytes->size();
}

Result<SiiWriteReport> load_eeprom(const EepromRequest& request, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail({.code = ErrorCode::kFileNotFound, .file = path});
  const std::vector<char> text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return fail({.code = ErrorCode::kFileNotReadable, .file = path});
  const std::vector<std::uint8_t> image(text.begin(), text.end());
  return with_slave_of(request, [&](Bus& bus, const SlaveAddress& slave) { return write_eeprom(bus, slave, image); });
}

Result<SiiWriteReport> set_eeprom_alias(const EepromRequest& request, std::uint16_t alias) {
  return with_slave_of(request, [&](Bus& bus, const SlaveAddress& slave) { return write_alias(bus, slave, alias); });
}

}  // namespace syncline
