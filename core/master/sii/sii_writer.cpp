// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "master/exchange/bus.h"
#include "master/sii/sii_access.h"
#include "master/sii/sii_layout.h"
#include "master/sii/sii_work.h"
#include "protocol/sii.h"
#include "protocol/station_alias.h"
#include "reasons/because.h"
#include "reasons/brief_reason.h"

namespace syncline {
namespace {

/// One slave's EEPROM while it is in our hands.
class Eeprom {
 public:
  Eeprom(Bus& bus, const SlaveAddress& slave)
      : bus_(bus), slave_(slave), access_(bus, {slave}, {.take_ownership = true, .broadcast = false}) {}

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

  Bus& bus() { return bus_; }
  [[nodiscard]] const SlaveAddress& slave() const { return slave_; }

 private:
  Result<std::array<std::uint8_t, kSiiPiece>> read_piece(std::size_t byte) {
    SiiRequest request{0, static_cast<std::uint32_t>(byte / 2), {}, {}};
    if (auto status = access_.read(std::span(&request, 1)); !status) return tl::unexpected(status.error());
    if (request.error) return tl::unexpected(*request.error);
    return request.data;
  }

  Bus& bus_;
  SlaveAddress slave_;
  SiiAccess access_;
};

struct Differences {
  std::size_t count = 0, first = 0, end = 0;  // words
};
Differences differences(std::span<const std::uint8_t> before, std::span<const std::uint8_t> after) {
  Differences found;
  for (std::size_t word = 0; 2 * word + 1 < after.size(); ++word) {
    const auto at = 2 * word;
    if (before[at] == after[at] && before[at + 1] == after[at + 1]) continue;
    if (found.count++ == 0) found.first = word;
    found.end = word + 1;
  }
  return found;
}

/// To its end, also when the user wants an end or the bus fails: then it puts back first what it has written.
Status run_write(Bus& bus, SiiWork& work) {
  SlaveWork* const works[] = {&work};
  if (const auto status = run_side_by_side(bus, works); !status) {
    work.cancel();
    const NotCancellable to_the_end(bus);
    if (!run_side_by_side(bus, works))
      work.give_up({.code = ErrorCode::kSii, .why = brief("writing ended early{which}")});
    const bool by_user = status.error().code == ErrorCode::kCancelled;
    if (!by_user && work.written() == 0) return status;
  }
  return work.result();
}

Result<SiiWriteReport> make_it(Eeprom& eeprom, std::span<const std::uint8_t> before,
                               std::span<const std::uint8_t> after, const SiiProgress& progress,
                               const SiiIntent& intent) {
  const auto [count, first, end] = differences(before, after);
  if (count == 0) return SiiWriteReport{after.size() / 2, 0};
  if (intent) {
    if (auto status = intent(before.first(after.size()), after); !status) return tl::unexpected(status.error());
  }
  std::vector<std::uint8_t> found;
  SiiWork work;
  if (progress) work.set_progress([&progress, all = count](std::size_t done) { progress(done, all); });
  work.write(eeprom.slave(), static_cast<std::uint32_t>(first), after.subspan(2 * first, 2 * (end - first)), found,
             true);
  if (auto status = run_write(eeprom.bus(), work); !status) return tl::unexpected(status.error());
  return SiiWriteReport{after.size() / 2, work.written()};
}

Status check(std::span<const std::uint8_t> image) {
  const auto bad = [](Reason why) { return fail(ErrorCode::kBadValue, "SII image", std::move(why)); };
  if (image.size() % 2 != 0) return bad(because("it has an odd number of bytes"));
  if (image.size() < kSiiHeaderBytes)
    return bad(because("it is shorter than the header of {bytes} bytes", kSiiHeaderBytes));
  const auto right = sii::checksum(image.first(kSiiChecksumByte));
  if (right != image[kSiiChecksumByte]) {
    return bad(because("its checksum is 0x{has} where 0x{right} is right",
                       fmt::format("{:02X}", image[kSiiChecksumByte]), fmt::format("{:02X}", right)));
  }
  return {};
}

}  // namespace

Result<std::vector<std::uint8_t>> read_eeprom(Bus& bus, const SlaveAddress& slave, const SiiProgress& progress,
                                              std::size_t bytes_wanted) {
  Eeprom eeprom(bus, slave);
  return eeprom.with([&]() -> Result<std::vector<std::uint8_t>> {
    std::vector<std::uint8_t> bytes;
    const auto header = bytes_wanted > 0 ? std::size_t{0} : kSiiHeaderBytes;
    if (auto status = eeprom.read(bytes, header, {}, 0); !status) return tl::unexpected(status.error());
    const auto size = bytes_wanted > 0 ? bytes_wanted : sii::image_size(bytes);
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
    if (auto status = eeprom.read(before, kSiiHeaderBytes, {}, 0); !status) return tl::unexpected(status.error());
    const auto room = std::max(sii::image_size(before), sii::image_size(image));
    if (image.size() > room) {
      return fail(ErrorCode::kBadValue, "SII image",
                  because("its {bytes} bytes are more than the EEPROM's {room}", image.size(), room));
    }
    if (auto status = eeprom.read(before, image.size(), {}, 0); !status) return tl::unexpected(status.error());
    return make_it(eeprom, before, image, progress, intent);
  });
}

Result<SiiWriteReport> write_image(Bus& bus, const SlaveAddress& slave, std::span<const std::uint8_t> image,
                                   const SiiIntent& intent) {
  if (image.size() % 2 != 0) return fail(ErrorCode::kBadValue, "SII image", because("it has an odd number of bytes"));
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
    if (auto status = eeprom.read(before, 2 * kSiiConfigurationWords, {}, 0); !status)
      return tl::unexpected(status.error());
    auto after = before;
    store_le(std::span(after).subspan(kSiiAliasByte), alias);
    after[kSiiChecksumByte] = sii::checksum(std::span(after).first(kSiiChecksumByte));
    return make_it(eeprom, before, after, {}, intent);
  });
}

bool old_content_is_back(const Error& error) {
  const auto given = error.detail.given();
  return !given.empty() && given.back() == Reason::phrase(kOldContentIsBack);
}

}  // namespace syncline
