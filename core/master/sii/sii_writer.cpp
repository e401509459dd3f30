// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "master/sii/sii_access.h"
#include "protocol/sii.h"

namespace syncline {
namespace {

constexpr std::size_t kHeaderBytes = 2 * sii::kCategoriesWord;
constexpr std::size_t kSizeByte = 2 * 0x3E;
constexpr std::size_t kLongestImage = 128 * 1024;
constexpr std::size_t kUsualSize = 2048;
constexpr std::uint32_t kConfigurationWords = 8;
constexpr std::size_t kAliasByte = 8, kChecksumByte = 14;
constexpr std::size_t kPiece = 8;

/// One slave's EEPROM while it is in our hands.
class Eeprom {
 public:
  Eeprom(Bus& bus, const SlaveAddress& slave)
      : bus_(bus), access_(bus, {slave}, {.take_ownership = true, .broadcast = false}) {}

  template <class Work>
  auto with(Work work) -> decltype(work()) {
    if (auto status = access_.open(); !status) return tl::unexpected(status.error());
    auto result = work();
    if (auto closed = access_.close(); !closed && result) return tl::unexpected(closed.error());
    return result;
  }

  /// Appends bytes until there are `size`.
  Status read(std::vector<std::uint8_t>& bytes, std::size_t size, const SiiProgress& progress, std::size_t all) {
    while (bytes.size() < size) {
      const auto piece = read_piece(bytes.size());
      if (!piece) return tl::unexpected(piece.error());
      bytes.insert(bytes.end(), piece->begin(), piece->end());
      if (progress) progress(bytes.size() / 2, all);
    }
    return {};
  }

  Status write(std::uint32_t at, std::uint16_t value) {
    if (auto status = access_.write(0, at, value); !status) return status;
    const auto found = word(at);
    if (!found) return tl::unexpected(found.error());
    if (*found == value) return {};
    return fail(ErrorCode::kSii, "slave",
                fmt::format("word 0x{:04X} reads 0x{:04X} after 0x{:04X} was written", at, *found, value));
  }
  Result<std::uint16_t> word(std::uint32_t at) {
    const auto piece = read_piece(2 * std::size_t{at});
    if (!piece) return tl::unexpected(piece.error());
    return load_le<std::uint16_t>(*piece);
  }

  Bus& bus() { return bus_; }

 private:
  Result<std::array<std::uint8_t, kPiece>> read_piece(std::size_t byte) {
    SiiRequest request{0, static_cast<std::uint32_t>(byte / 2), {}, {}};
    if (auto status = access_.read(std::span(&request, 1)); !status) return tl::unexpected(status.error());
    if (request.error) return tl::unexpected(*request.error);
    return request.data;
  }

  Bus& bus_;
  SiiAccess access_;
};

std::size_t size_of(std::span<const std::uint8_t> header) {
  const auto size = (load_le<std::uint16_t>(header.subspan(kSizeByte)) + std::size_t{1}) * 128;
  return size < kHeaderBytes || size > kLongestImage ? kUsualSize : size;
}

struct Change {
  std::uint32_t word = 0;
  std::uint16_t before = 0, after = 0;
};

/// Different words; those of the configuration area last.
std::vector<Change> changes(std::span<const std::uint8_t> before, std::span<const std::uint8_t> after) {
  std::vector<Change> list;
  for (std::uint32_t word = 0; 2 * word + 1 < after.size(); ++word) {
    const Change change{word, load_le<std::uint16_t>(before.subspan(2 * word)),
                        load_le<std::uint16_t>(after.subspan(2 * word))};
    if (change.before != change.after) list.push_back(change);
  }
  std::stable_partition(list.begin(), list.end(),
                        [](const Change& change) { return change.word >= kConfigurationWords; });
  return list;
}

/// True when the word holds again what it held.
bool put_back(Eeprom& eeprom, const Change& change) {
  constexpr int kTries = 3;
  for (int i = 0; i < kTries; ++i) {
    if (eeprom.write(change.word, change.before)) return true;
    if (const auto found = eeprom.word(change.word); found && *found == change.before) return true;
  }
  return false;
}

Status write_changes(Eeprom& eeprom, std::span<const Change> list, const SiiProgress& progress) {
  std::size_t done = 0;
  Status status;
  for (; done < list.size() && status; ++done) {
    status = eeprom.write(list[done].word, list[done].after);
    if (status && progress) progress(done + 1, list.size());
  }
  if (status) return {};
  // Back to what it was, newest first; this must not be cancelled.
  const NotCancellable to_the_end(eeprom.bus());
  std::size_t left = 0;
  while (done-- > 0) left += put_back(eeprom, list[done]) ? 0 : 1;
  auto error = status.error();
  if (error.code == ErrorCode::kCancelled && left == 0) return tl::unexpected(error);
  const auto outcome = left == 0 ? std::string(kOldContentIsBack)
                                 : fmt::format(
                                       "{} words could not be put back; write the image again before power is "
                                       "switched off",
                                       left);
  return fail(ErrorCode::kSii, "slave",
              fmt::format("{}; {}", error.detail.empty() ? "writing ended early" : error.detail, outcome));
}

Result<SiiWriteReport> make_it(Eeprom& eeprom, std::span<const std::uint8_t> before,
                               std::span<const std::uint8_t> after, const SiiProgress& progress,
                               const SiiIntent& intent) {
  const auto list = changes(before, after);
  if (intent && !list.empty()) {
    if (auto status = intent(before.first(after.size()), after); !status) return tl::unexpected(status.error());
  }
  if (auto status = write_changes(eeprom, list, progress); !status) return tl::unexpected(status.error());
  const NotCancellable to_the_end(eeprom.bus());  // it is written: only the proof is missing
  std::vector<std::uint8_t> now;
  if (auto status = eeprom.read(now, after.size(), {}, 0); !status) return tl::unexpected(status.error());
  if (!std::equal(after.begin(), after.end(), now.begin())) {
    return fail(ErrorCode::kSii, "slave", "the content changed again after every word had been verified");
  }
  return SiiWriteReport{after.size() / 2, list.size()};
}

Status check(std::span<const std::uint8_t> image) {
  const auto bad = [](std::string why) { return fail(ErrorCode::kBadValue, "SII image", std::move(why)); };
  if (image.size() % 2 != 0) return bad("it has an odd number of bytes");
  if (image.size() < kHeaderBytes) return bad(fmt::format("it is shorter than the header of {} bytes", kHeaderBytes));
  const auto right = sii::checksum(image.first(14));
  if (right != image[kChecksumByte]) {
    return bad(fmt::format("its checksum is 0x{:02X} where 0x{:02X} is right", image[kChecksumByte], right));
  }
  return {};
}

}  // namespace

Result<std::vector<std::uint8_t>> read_eeprom(Bus& bus, const SlaveAddress& slave, const SiiProgress& progress,
                                              std::size_t bytes_wanted) {
  Eeprom eeprom(bus, slave);
  return eeprom.with([&]() -> Result<std::vector<std::uint8_t>> {
    std::vector<std::uint8_t> bytes;
    const auto header = bytes_wanted > 0 ? std::size_t{0} : kHeaderBytes;
    if (auto status = eeprom.read(bytes, header, {}, 0); !status) return tl::unexpected(status.error());
    const auto size = bytes_wanted > 0 ? bytes_wanted : size_of(bytes);
    if (auto status = eeprom.read(bytes, size, progress, size / 2); !status) return tl::unexpected(status.error());
    bytes.resize(size);
    return bytes;
  });
}

Result<SiiWriteReport> write_eeprom(Bus& bus, const SlaveAddress& slave, std::span<const std::uint8_t> image,
                                    const SiiProgress& progress, const SiiIntent& intent) {
  if (auto status = check(image); !status) return tl::unexpected(status.error());
  Eeprom eeprom(bus, slave);
  return eeprom.with([&]() -> Result<SiiWriteReport> {
    std::vector<std::uint8_t> before;
    if (auto status = eeprom.read(before, kHeaderBytes, {}, 0); !status) return tl::unexpected(status.error());
    const auto room = std::max(size_of(before), size_of(image));
    if (image.size() > room) {
      return fail(ErrorCode::kBadValue, "SII image",
                  fmt::format("its {} bytes are more than the EEPROM's {}", image.size(), room));
    }
    if (auto status = eeprom.read(before, image.size(), {}, 0); !status) return tl::unexpected(status.error());
    return make_it(eeprom, before, image, progress, intent);
  });
}

Result<SiiWriteReport> write_image(Bus& bus, const SlaveAddress& slave, std::span<const std::uint8_t> image,
                                   const SiiIntent& intent) {
  if (image.size() % 2 != 0) return fail(ErrorCode::kBadValue, "SII image", "it has an odd number of bytes");
  Eeprom eeprom(bus, slave);
  return eeprom.with([&]() -> Result<SiiWriteReport> {
    std::vector<std::uint8_t> before;
    if (auto status = eeprom.read(before, image.size(), {}, 0); !status) return tl::unexpected(status.error());
    return make_it(eeprom, before, image, {}, intent);
  });
}

Result<SiiWriteReport> write_alias(Bus& bus, const SlaveAddress& slave, std::uint16_t alias, const SiiIntent& intent) {
  Eeprom eeprom(bus, slave);
  return eeprom.with([&]() -> Result<SiiWriteReport> {
    std::vector<std::uint8_t> before;
    if (auto status = eeprom.read(before, 2 * kConfigurationWords, {}, 0); !status)
      return tl::unexpected(status.error());
    auto after = before;
    store_le(std::span(after).subspan(kAliasByte), alias);
    after[kChecksumByte] = sii::checksum(std::span(after).first(14));
    return make_it(eeprom, before, after, {}, intent);
  });
}

}  // namespace syncline
