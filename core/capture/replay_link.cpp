// SPDX-License-Identifier: Apache-2.0
#include "capture/replay_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>

#include "capture/pcap_reader.h"
#include "capture/recorded_bus.h"
#include "link/link.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "protocol/station_alias.h"
#include "reasons/because.h"
#include "support/byte_order.h"
#include "support/clock.h"

namespace syncline {
namespace {

constexpr std::uint16_t kSiiCommandError = 0x2000;
constexpr unsigned kSiiReadCommand = 1;
/// What every ESC has and a master must be able to write before it can read anything.
constexpr bool is_addressing(std::uint32_t address) {
  return (address >= reg::kStationAddress && address < reg::kStationAddress + 2U) ||
         (address >= reg::kDlControl && address < reg::kDlControl + 4U) ||
         (address >= reg::kSiiConfiguration && address < reg::kSiiData + 8U);
}

/// Every ESC has these: a broadcast is counted by each slave, also by one whose value nobody read alone.
constexpr bool is_mandatory(std::uint32_t address) {
  return address < reg::kFeatures + 2U || (address >= reg::kDlStatus && address < reg::kDlStatus + 2U) ||
         (address >= reg::kAlStatus && address < reg::kAlStatus + 2U);
}

class ReplayedSlave {
 public:
  explicit ReplayedSlave(RecordedSlave recorded) : recorded_(std::move(recorded)) {
    // The capture's master gave its own; ours gives others.
    store(reg::kStationAddress, std::uint16_t{0});
    store(reg::kSiiControl, std::uint16_t{0});
    for (std::uint32_t a = reg::kSiiConfiguration; a < reg::kSiiData + 8U; ++a)
      recorded_.memory.try_emplace(a, std::uint8_t{0});
  }
  [[nodiscard]] std::uint16_t station() const { return load<std::uint16_t>(reg::kStationAddress); }

  bool read(std::uint16_t address, std::span<std::uint8_t> out) const {
    if (!recorded_.knows(address, out.size())) return false;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = byte(address + i);
    return true;
  }
  /// ORs what is known.
  bool read_broadcast(std::uint16_t address, std::span<std::uint8_t> out) const {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const auto a = static_cast<std::uint32_t>(address + i);
      if (!recorded_.knows(a, 1) && !is_mandatory(a)) return false;
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = static_cast<std::uint8_t>(out[i] | byte(address + i));
    }
    return true;
  }
  bool write(std::uint16_t address, std::span<const std::uint8_t> data) {
    for (std::size_t i = 0; i < data.size(); ++i) {
      const auto a = static_cast<std::uint32_t>(address + i);
      if (!recorded_.knows(a, 1) && !is_addressing(a)) return false;
    }
    for (std::size_t i = 0; i < data.size(); ++i) {
      recorded_.memory[static_cast<std::uint32_t>(address + i)] = data[i];
    }
    if (address <= reg::kSiiControl + 1U && address + data.size() > reg::kSiiControl + 1U) run_sii_command();
    return true;
  }

 private:
  /// 0 where nothing is known.
  [[nodiscard]] std::uint8_t byte(std::size_t address) const {
    const auto found = recorded_.memory.find(static_cast<std::uint32_t>(address));
    return found == recorded_.memory.end() ? std::uint8_t{0} : found->second;
  }
  template <std::unsigned_integral T>
  [[nodiscard]] T load(std::uint32_t address) const {
    std::array<std::uint8_t, sizeof(T)> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = byte(address + i);
    return load_le<T>(bytes);
  }
  template <std::unsigned_integral T>
  void store(std::uint32_t address, T value) {
    const auto bytes = le_bytes(value);
    for (std::size_t i = 0; i < bytes.size(); ++i) recorded_.memory[static_cast<std::uint32_t>(address + i)] = bytes[i];
  }

  void run_sii_command() {
    const unsigned command = byte(reg::kSiiControl + 1U) & 0x07U;
    std::uint16_t result = 0;
    if (command == kSiiReadCommand) {
      // Two words at a time, also where the recorded ESC gave four: fewer have to be known.
      const auto word = load<std::uint32_t>(reg::kSiiAddress);
      for (unsigned i = 0; i < 2; ++i) {
        const auto found = recorded_.sii.find(word + i);
        if (found == recorded_.sii.end()) result |= kSiiCommandError;
        store(reg::kSiiData + 2 * i, found == recorded_.sii.end() ? std::uint16_t{0} : found->second);
      }
    } else if (command != 0) {
      result |= kSiiCommandError;  // a recording is not written to
    }
    store(reg::kSiiControl, result);
  }

  RecordedSlave recorded_;
};

class ReplayLink final : public Link {
 public:
  ReplayLink(std::string path, const std::vector<RecordedSlave>& slaves, VirtualClock& clock)
      : path_(std::move(path)), slaves_(slaves.begin(), slaves.end()), clock_(clock) {}

  Status send(std::span<const std::uint8_t> frame) override {
    std::vector<std::uint8_t> bytes(frame.begin(), frame.end());
    FrameReader reader(bytes);
    while (auto datagram = reader.next()) execute(*datagram);
    if (reader.is_ethercat() && !reader.malformed()) answers_.push_back(std::move(bytes));
    return {};
  }

  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    if (answers_.empty()) {
      clock_.advance_to(std::max(deadline, clock_.now()));
      return ReceivedFrame{};
    }
    const auto bytes = std::move(answers_.front());
    answers_.pop_front();
    clock_.advance_to(clock_.now() + wire_time_ns(bytes.size()));
    const auto length = std::min(bytes.size(), buffer.size());
    std::copy_n(bytes.begin(), length, buffer.begin());
    return ReceivedFrame{length, clock_.now()};
  }

  [[nodiscard]] LinkDescription describe() const override {
    return {"replay:" + path_, "replay", {0x00, 0x53, 0x4C, 0x00, 0x00, 0x02}, true};
  }

 private:
  void execute(DatagramView& datagram) {
    auto& header = datagram.header;
    auto adp = header.adp();
    std::uint16_t wkc = datagram.wkc();
    // What a write puts down is what the master sent, not what an earlier slave answered.
    const std::vector<std::uint8_t> sent(datagram.data.begin(), datagram.data.end());
    for (auto& slave : slaves_) {
      const bool addressed = is_auto_increment(header.command)  ? adp == 0
                             : is_fixed_address(header.command) ? slave.station() == header.adp()
                                                                : is_broadcast(header.command);
      if (is_auto_increment(header.command) || is_broadcast(header.command)) ++adp;
      if (addressed) wkc = static_cast<std::uint16_t>(wkc + access(slave, datagram, sent));
    }
    header.address = is_logical(header.command) ? header.address : device_address(adp, header.ado());
    datagram.store_header();
    datagram.set_wkc(wkc);
  }

  static unsigned access(ReplayedSlave& slave, const DatagramView& datagram, std::span<const std::uint8_t> sent) {
    const auto& header = datagram.header;
    const bool both =
        header.command == Command::kAprw || header.command == Command::kFprw || header.command == Command::kBrw;
    const bool multiple = header.command == Command::kArmw || header.command == Command::kFrmw;
    unsigned count = 0;
    if (!writes(header.command) || both || multiple) {
      count += is_broadcast(header.command) ? slave.read_broadcast(header.ado(), datagram.data)
                                            : slave.read(header.ado(), datagram.data);
    }
    if (writes(header.command) && !multiple && slave.write(header.ado(), sent)) count += both ? 2 : 1;
    return count;
  }

  std::string path_;
  std::vector<ReplayedSlave> slaves_;
  VirtualClock& clock_;
  std::deque<std::vector<std::uint8_t>> answers_;
};

}  // namespace

namespace {

ReplayNotes::Slave note_of(const RecordedSlave& slave) {
  constexpr std::uint32_t kAliasWord = kSiiAliasByte / 2, kVendorWord = 8, kProductWord = 10, kRevisionWord = 12,
                          kSerialWord = 14;
  constexpr unsigned kDcFeature = 0x0004;
  const auto has_words = [&](std::uint32_t word) { return slave.sii.contains(word) && slave.sii.contains(word + 1); };
  const auto was_read = [&](std::uint32_t address, std::uint32_t size) {
    for (std::uint32_t i = 0; i < size; ++i) {
      if (!slave.memory.contains(address + i)) return false;
    }
    return true;
  };
  ReplayNotes::Slave note;
  note.vendor_id = has_words(kVendorWord);
  note.product_code = has_words(kProductWord);
  note.revision_no = has_words(kRevisionWord);
  note.serial_no = has_words(kSerialWord);
  note.alias = slave.sii.contains(kAliasWord) || was_read(reg::kStationAlias, 2);
  note.state = was_read(reg::kAlStatus, 2);
  note.ports = was_read(reg::kDlStatus, 2);
  const bool without_dc = was_read(reg::kFeatures, 2) && (slave.memory.at(reg::kFeatures) & kDcFeature) == 0;
  note.dc = without_dc || was_read(reg::kSystemTime, 4) || was_read(reg::kReceiveTimePort0, 4);
  note.sii_words = slave.sii.size();
  return note;
}

}  // namespace

Result<std::unique_ptr<Link>> make_replay_link(const std::string& path, VirtualClock& clock, ReplayNotes* notes) {
  auto reader = PcapReader::open(path);
  if (!reader) return tl::unexpected(reader.error());
  BusRecorder recorder;
  ReplayNotes found;
  for (;;) {
    auto frame = reader->next();
    if (!frame) {
      if (recorder.exchanges() == 0) return tl::unexpected(frame.error());
      found.broken_off = frame.error();
      break;
    }
    if (!*frame) break;
    ++found.frames;
    if ((*frame)->truncated) {
      ++found.cut_frames;
      continue;
    }
    recorder.add((*frame)->bytes);
  }
  if (recorder.exchanges() == 0) {
    const auto why = found.cut_frames == 0
                         ? because("a capture with EtherCAT frames and their answers")
                         : because("a capture of whole frames; {cut} of its {frames} were captured in part only",
                                   found.cut_frames, found.frames);
    return fail(Error{ErrorCode::kNotThatKindOfFile, {}, why, path});
  }
  const auto slaves = recorder.slaves();
  for (const auto& slave : slaves) found.slaves.push_back(note_of(slave));
  if (notes != nullptr) *notes = std::move(found);
  return std::make_unique<ReplayLink>(path, slaves, clock);
}

}  // namespace syncline
