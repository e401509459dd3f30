// SPDX-License-Identifier: Apache-2.0
#include "capture/recorded_bus.h"

#include <algorithm>

#include "link/link.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// More than any master has under way; what is older was lost.
constexpr std::size_t kMostOpen = 256;
/// Positions beyond what a segment can have are a damaged frame's.
constexpr std::size_t kMostSlaves = 4096;
constexpr std::uint16_t kSiiBusy = 0x8000;
constexpr std::uint16_t kSiiReads8Bytes = 0x0040;
constexpr std::uint16_t kSiiEnd = reg::kSiiData + 8;

bool reads(Command command) {
  return command != Command::kNop && command != Command::kApwr && command != Command::kFpwr &&
         command != Command::kBwr && command != Command::kLwr;
}

bool same_datagram(const DatagramHeader& sent, const DatagramHeader& returned) {
  // Auto-increment and broadcast addresses were counted up on the way.
  return sent.command == returned.command && sent.index == returned.index && sent.length == returned.length &&
         sent.ado() == returned.ado();
}

}  // namespace

bool RecordedSlave::knows(std::uint32_t address, std::size_t length) const {
  for (std::size_t i = 0; i < length; ++i) {
    const auto a = static_cast<std::uint32_t>(address + i);
    if (!memory.contains(a) && (!written_to_all || !written_to_all->contains(a))) return false;
  }
  return true;
}

std::vector<RecordedSlave> BusRecorder::slaves() const {
  std::vector<RecordedSlave> all(count_);
  for (const auto& [position, known] : known_) all[position] = known.slave;
  for (auto& slave : all) slave.written_to_all = written_to_all_;
  return all;
}

BusRecorder::Known& BusRecorder::known(std::size_t position) {
  count_ = std::max(count_, position + 1);
  return known_.try_emplace(position, Known{{}, sii_address_of_all_, 0}).first->second;
}

void BusRecorder::add(std::span<std::uint8_t> frame) {
  FrameReader reader(frame);
  if (!reader.is_ethercat()) return;
  SentFrame read;
  std::copy_n(frame.begin() + 6, 6, read.source.begin());
  std::vector<std::uint16_t> counters;
  while (const auto datagram = reader.next()) {
    read.datagrams.push_back({datagram->header, {datagram->data.begin(), datagram->data.end()}});
    counters.push_back(datagram->wkc());
  }
  if (reader.malformed() || read.datagrams.empty()) return;

  const auto request = find_request(read);
  if (!request) {
    if (open_.size() == kMostOpen) open_.erase(open_.begin());
    open_.push_back(std::move(read));
    return;
  }
  const auto sent = std::move(open_[*request]);
  open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(*request));
  ++exchanges_;
  for (std::size_t i = 0; i < sent.datagrams.size(); ++i) {
    if (counters[i] > 0) learn(sent.datagrams[i], read.datagrams[i], counters[i]);
  }
}

std::optional<std::size_t> BusRecorder::find_request(const SentFrame& frame) const {
  for (std::size_t i = open_.size(); i > 0; --i) {
    const auto& sent = open_[i - 1];
    // The first slave sets the bit; a master whose address has it already leaves no difference.
    auto marked = sent.source;
    marked[0] |= kLocallyAdministered;
    if (marked != frame.source) continue;
    if (std::ranges::equal(sent.datagrams, frame.datagrams,
                           [](const Sent& a, const Sent& b) { return same_datagram(a.header, b.header); })) {
      return i - 1;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> BusRecorder::position_of(const DatagramHeader& header) const {
  if (is_auto_increment(header.command)) {
    const std::size_t position = static_cast<std::uint16_t>(0U - header.adp());
    return position < kMostSlaves ? std::optional(position) : std::nullopt;
  }
  if (!is_fixed_address(header.command)) return std::nullopt;
  const auto found = stations_.find(header.adp());
  return found == stations_.end() ? std::nullopt : std::optional(found->second);
}

void BusRecorder::learn(const Sent& sent, const Sent& returned, std::uint16_t wkc) {
  if (is_broadcast(sent.header.command)) return learn_broadcast(sent, wkc);
  const auto position = position_of(sent.header);
  if (!position) return;
  const auto address = sent.header.ado();
  if (writes(sent.header.command) && sent.header.command != Command::kArmw && sent.header.command != Command::kFrmw) {
    note_write(*position, address, sent.data);
  }
  if (reads(sent.header.command)) note_read(*position, address, returned.data);
}

void BusRecorder::learn_broadcast(const Sent& sent, std::uint16_t wkc) {
  const std::size_t each = sent.header.command == Command::kBrw ? 3 : 1;
  if (wkc % each == 0) count_ = std::max(count_, std::min<std::size_t>(wkc / each, kMostSlaves));
  if (!writes(sent.header.command)) return;  // an OR of all says nothing of one
  note_broadcast_write(sent.header.ado(), sent.data);
}

/// Once for all of them.
void BusRecorder::note_broadcast_write(std::uint16_t address, std::span<const std::uint8_t> data) {
  std::optional<std::uint32_t> sii_address;
  if (address == reg::kSiiControl && data.size() >= 6) sii_address = load_le<std::uint32_t>(data.subspan(2));
  if (address == reg::kSiiAddress && data.size() >= 4) sii_address = load_le<std::uint32_t>(data);
  if (sii_address) {
    sii_address_of_all_ = *sii_address;
    for (auto& [position, known] : known_) known.sii_address = *sii_address;
  }
  if (address >= reg::kReceiveTimePort0 && address < reg::kSystemTime) return;
  for (std::size_t i = 0; i < data.size(); ++i) written_to_all_->insert(static_cast<std::uint32_t>(address + i));
}

void BusRecorder::note_write(std::size_t position, std::uint16_t address, std::span<const std::uint8_t> data) {
  auto& to = known(position);
  if (address == reg::kStationAddress && data.size() >= 2) {
    std::erase_if(stations_, [position](const auto& entry) { return entry.second == position; });
    stations_[load_le<std::uint16_t>(data)] = position;
  }
  if (address == reg::kSiiControl && data.size() >= 6) to.sii_address = load_le<std::uint32_t>(data.subspan(2));
  if (address == reg::kSiiAddress && data.size() >= 4) to.sii_address = load_le<std::uint32_t>(data);
  // Receive times are not what is written there, which only latches them.
  if (address >= reg::kReceiveTimePort0 && address < reg::kSystemTime) return;
  // The register is there; its value before the write is not known, and after it is the master's.
  for (std::size_t i = 0; i < data.size(); ++i) {
    to.slave.memory.try_emplace(static_cast<std::uint32_t>(address + i), std::uint8_t{0});
  }
}

void BusRecorder::note_read(std::size_t position, std::uint16_t address, std::span<const std::uint8_t> data) {
  auto& from = known(position);
  if (address == reg::kStationAddress && data.size() >= 2)
    stations_.try_emplace(load_le<std::uint16_t>(data), position);
  if (address < kSiiEnd && address + data.size() > reg::kSiiControl) note_sii(from, address, data);
  for (std::size_t i = 0; i < data.size(); ++i) {
    from.slave.memory.try_emplace(static_cast<std::uint32_t>(address + i), data[i]);
  }
}

void BusRecorder::note_sii(Known& from, std::uint16_t address, std::span<const std::uint8_t> data) {
  const auto end = address + data.size();
  if (address <= reg::kSiiControl && end >= reg::kSiiControl + 2U) {
    from.sii_status = load_le<std::uint16_t>(data.subspan(reg::kSiiControl - address));
    from.slave.reads_8_bytes |= (from.sii_status & kSiiReads8Bytes) != 0;
  }
  if (address > reg::kSiiData || end <= reg::kSiiData || (from.sii_status & kSiiBusy) != 0) return;
  const auto words = data.subspan(reg::kSiiData - address);
  const std::size_t valid = from.slave.reads_8_bytes ? 8 : 4;
  for (std::size_t i = 0; i + 1 < std::min(words.size(), valid); i += 2) {
    from.slave.sii.try_emplace(from.sii_address + static_cast<std::uint32_t>(i / 2),
                               load_le<std::uint16_t>(words.subspan(i)));
  }
}

}  // namespace syncline
