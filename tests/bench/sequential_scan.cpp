// SPDX-License-Identifier: Apache-2.0
#include "bench/sequential_scan.h"

#include <array>
#include <tl/expected.hpp>

#include "protocol/registers.h"
#include "support/byte_order.h"
#include "support/types.h"

namespace syncline::bench {
namespace {

constexpr std::uint16_t kReadCommand = 0x0100, kBusy = 0x8000;

Result<std::array<std::uint8_t, 8>> read_piece(Bus& bus, std::uint16_t station, std::uint32_t word) {
  std::array<std::uint8_t, 6> command{};
  store_le(command, kReadCommand);
  store_le(std::span(command).subspan(2), word);
  if (auto wkc = bus.exchange(Command::kFpwr, station, reg::kSiiControl, command); !wkc)
    return tl::unexpected(wkc.error());
  for (;;) {
    const auto control = bus.read<std::uint16_t>(station, reg::kSiiControl, "slave");
    if (!control) return tl::unexpected(control.error());
    if ((*control & kBusy) == 0) break;
  }
  std::array<std::uint8_t, 8> data{};
  if (auto wkc = bus.exchange(Command::kFprd, station, reg::kSiiData, data); !wkc) return tl::unexpected(wkc.error());
  return data;
}

Result<std::vector<std::uint8_t>> read_image(Bus& bus, std::uint16_t station) {
  std::vector<std::uint8_t> bytes;
  std::size_t category = 2 * sii::kCategoriesWord;
  for (;;) {
    const auto piece = read_piece(bus, station, static_cast<std::uint32_t>(bytes.size() / 2));
    if (!piece) return tl::unexpected(piece.error());
    bytes.insert(bytes.end(), piece->begin(), piece->end());
    while (bytes.size() >= category + 4) {
      const auto word = [&](std::size_t at) { return load_le<std::uint16_t>(std::span(bytes).subspan(at)); };
      if (word(category) == 0xFFFF) return bytes;
      category += 4 + 2 * std::size_t{word(category + 2)};
    }
  }
}

}  // namespace

Result<std::vector<sii::Image>> sequential_scan(Bus& bus) {
  std::array<std::uint8_t, 1> type{};
  const auto count = bus.exchange(Command::kBrd, 0, reg::kType, type);
  if (!count) return tl::unexpected(count.error());
  std::vector<sii::Image> images;
  for (std::uint16_t i = 0; i < *count; ++i) {
    const auto station = static_cast<std::uint16_t>(1001 + i);
    auto address = le_bytes(station);
    const auto adp = Position{i}.auto_increment_address();
    if (auto wkc = bus.exchange(Command::kApwr, adp, reg::kStationAddress, address); !wkc)
      return tl::unexpected(wkc.error());
    for (const auto ado :
         {reg::kType, reg::kFeatures, reg::kStationAlias, reg::kDlStatus, reg::kAlStatus, reg::kSystemTime}) {
      if (auto value = bus.read<std::uint16_t>(station, ado, "slave"); !value && ado != reg::kSystemTime) {
        return tl::unexpected(value.error());
      }
    }
    const auto bytes = read_image(bus, station);
    if (!bytes) return tl::unexpected(bytes.error());
    auto image = sii::decode(*bytes);
    if (!image) return tl::unexpected(image.error());
    images.push_back(std::move(*image));
  }
  return images;
}

}  // namespace syncline::bench
