// SPDX-License-Identifier: Apache-2.0
#include "master/sii_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "protocol/registers.h"
#include "protocol/sii.h"

namespace syncline {
namespace {

constexpr std::uint16_t kReadCommand = 0x0100;
constexpr std::uint16_t kReadsEightBytes = 0x0040;
constexpr std::uint16_t kErrorBits = 0x7800;
constexpr std::uint16_t kCommandError = 0x2000;
constexpr std::uint16_t kBusy = 0x8000;
constexpr std::size_t kSizeWord = 0x3E;
constexpr std::size_t kHeaderBytes = sii::kCategoriesWord * 2;
constexpr std::size_t kLongestImage = 128 * 1024;  // 1 Mbit, the largest EEPROM in use
constexpr int kMaxPolls = 2000;

/// One slave's read in progress: 0x0502 (control, address) and 0x0508 (data) lie side by side, so that
/// one datagram starts a read and one polls and fetches.
class SlaveRead {
 public:
  explicit SlaveRead(std::uint16_t station) : station_(station) {}

  [[nodiscard]] bool done() const { return done_; }
  SiiContent take() { return std::move(content_); }

  Datagram start() {
    store_le<std::uint16_t>(buffer_, kReadCommand);
    store_le(std::span(buffer_).subspan(2), static_cast<std::uint32_t>(content_.bytes.size() / 2));
    polls_ = 0;
    fetched_ = false;
    return {Command::kFpwr, device_address(station_, reg::kSiiControl), std::span(buffer_).first(6)};
  }
  [[nodiscard]] bool waiting() const { return !done_ && !fetched_; }
  Datagram poll() {
    buffer_.fill(0);
    return {Command::kFprd, device_address(station_, reg::kSiiControl), buffer_};
  }
  void polled(std::uint16_t wkc) {
    if (wkc == 0) return give_up("no answer");
    const auto control = load_le<std::uint16_t>(buffer_);
    if ((control & kBusy) != 0) {
      if (++polls_ > kMaxPolls) give_up("EEPROM stays busy");
      return;
    }
    fetched_ = true;
    if ((control & kCommandError) != 0) return give_up("EEPROM acknowledges no read command");
    const std::size_t count = (control & kReadsEightBytes) != 0 ? 8 : 4;
    content_.bytes.insert(content_.bytes.end(), buffer_.begin() + 6,
                          buffer_.begin() + 6 + static_cast<std::ptrdiff_t>(count));
    walk_categories();
  }
  void give_up(std::string why) {
    done_ = true;
    content_.error = Error{ErrorCode::kSii, fmt::format("station {}", station_), std::move(why)};
  }

 private:
  [[nodiscard]] std::size_t word(std::size_t byte) const {
    return load_le<std::uint16_t>(std::span(content_.bytes).subspan(byte));
  }
  [[nodiscard]] std::size_t size() const {
    return std::min(kLongestImage, (word(kSizeWord * 2) + 1) * 128);
  }
  void walk_categories() {
    const auto& bytes = content_.bytes;
    while (bytes.size() >= category_ + 4) {
      if (word(category_) == static_cast<std::size_t>(sii::CategoryType::kEnd)) {
        done_ = true;
        return;
      }
      category_ += 4 + 2 * word(category_ + 2);
    }
    if (bytes.size() > kSizeWord * 2 + 1 && bytes.size() >= size()) done_ = true;
  }

  std::uint16_t station_;
  std::array<std::uint8_t, 14> buffer_{};
  std::size_t category_ = kHeaderBytes;  // byte where the next category begins
  int polls_ = 0;
  bool fetched_ = false;
  bool done_ = false;
  SiiContent content_;
};

/// Sends one datagram for every read that `wanted` selects; afterwards `take` sees its answer.
template <class Wanted, class Make, class Take>
Status for_all(Bus& bus, std::vector<SlaveRead>& reads, Wanted wanted, Make make, Take take) {
  std::vector<Datagram> datagrams;
  std::vector<SlaveRead*> asked;
  for (auto& read : reads) {
    if (!wanted(read)) continue;
    datagrams.push_back(make(read));
    asked.push_back(&read);
  }
  if (auto status = bus.transact(datagrams); !status) return status;
  for (std::size_t i = 0; i < asked.size(); ++i) take(*asked[i], datagrams[i].wkc);
  return {};
}

/// Takes the EEPROM from the PDI and clears errors of earlier accesses.
Status take_control(Bus& bus, std::span<const std::uint16_t> stations) {
  for (const std::uint8_t value : {std::uint8_t{2}, std::uint8_t{0}}) {
    std::vector<std::array<std::uint8_t, 1>> bytes(stations.size(), {value});
    std::vector<Datagram> datagrams;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      datagrams.push_back({Command::kFpwr, device_address(stations[i], reg::kSiiConfiguration), bytes[i]});
    }
    if (auto status = bus.transact(datagrams); !status) return status;
  }
  for (const auto station : stations) {
    const auto control = bus.read<std::uint16_t>(station, reg::kSiiControl, "SII");
    if (!control) continue;  // told by the read that follows
    if ((*control & kErrorBits) == 0) continue;
    if (auto wkc = bus.write(Command::kFpwr, station, reg::kSiiControl, std::uint16_t{0}); !wkc) {
      return tl::unexpected(wkc.error());
    }
  }
  return {};
}

}  // namespace

Result<std::vector<SiiContent>> read_sii(Bus& bus, std::span<const std::uint16_t> stations,
                                         const std::function<void(std::size_t)>& progress) {
  if (auto status = take_control(bus, stations); !status) return tl::unexpected(status.error());
  std::vector<SlaveRead> reads;
  for (const auto station : stations) reads.emplace_back(station);
  const auto open = [](const SlaveRead& read) { return !read.done(); };
  const auto count_done = [&] {
    return reads.size() - static_cast<std::size_t>(std::ranges::count_if(reads, open));
  };
  std::size_t done = 0;
  while (done < reads.size()) {
    auto status = for_all(
        bus, reads, open, [](SlaveRead& read) { return read.start(); },
        [](SlaveRead& read, std::uint16_t wkc) {
          if (wkc == 0) read.give_up("no answer");
        });
    while (status && std::ranges::any_of(reads, &SlaveRead::waiting)) {
      status = for_all(
          bus, reads, [](const SlaveRead& read) { return read.waiting(); }, [](SlaveRead& read) { return read.poll(); },
          [](SlaveRead& read, std::uint16_t wkc) { read.polled(wkc); });
    }
    if (!status) return tl::unexpected(status.error());
    if (const auto now_done = count_done(); now_done != done) {
      done = now_done;
      if (progress) progress(done);
    }
  }
  std::vector<SiiContent> contents;
  for (auto& read : reads) contents.push_back(read.take());
  return contents;
}

}  // namespace syncline
