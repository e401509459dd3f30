// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "link/link.h"
#include "protocol/al_state.h"
#include "protocol/coe.h"
#include "protocol/datagram.h"
#include "protocol/dc_registers.h"
#include "protocol/dl_status.h"
#include "protocol/fmmu.h"
#include "protocol/frame.h"
#include "protocol/mailbox.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"
#include "support/byte_order.h"
#include "support/clock.h"

namespace syncline::test {

/// One slave of a TestBus: enough of an ESC to run a master against, far from an honest one (that is
/// core/sim). Memory, SII, AL state, SDO server, FMMUs by the byte, and a clock that follows at once.
struct TestSlave {
  std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(0x3000);
  std::vector<std::uint8_t> sii;
  bool has_system_time = true;
  bool has_mailbox = false;
  bool shows_sii_address = true;
  std::size_t sii_bytes = 8;  // a read gives, 4 or 8
  Nanoseconds sii_time = 0;   // that a read takes
  Nanoseconds sii_ready = 0;
  std::optional<std::uint16_t> device_id;  // answers the request by AL control bit 5
  bool present = true;
  double ppm = 0;
  double phase = 0;                                            // ns, added to the host clock to give the local time
  std::map<std::uint32_t, std::vector<std::uint8_t>> objects;  // index << 8 | sub-index
  std::vector<std::pair<std::uint32_t, std::vector<std::uint8_t>>> written;
  std::optional<std::pair<AlState, std::uint16_t>> refuse;  // state and AL status code
  std::vector<AlState> requests;
  int mailbox_delay = 0;  // polls until an answer is there
  std::optional<coe::Emergency> emergency;
  std::vector<std::uint8_t> download;  // of a segmented transfer
  coe::ObjectAddress transfer_object;
  std::vector<std::uint8_t> upload;
  std::deque<std::vector<std::uint8_t>> answers;
  std::array<std::uint32_t, 4> receive_times{};

  template <class T>
  [[nodiscard]] T get(std::uint16_t address) const {
    return load_le<T>(std::span(memory).subspan(address));
  }
  template <class T>
  void set(std::uint16_t address, T value) {
    store_le(std::span(memory).subspan(address), value);
  }
  [[nodiscard]] double local(Nanoseconds t) const {
    return static_cast<double>(t % (1000 * kSecond)) * (1 + ppm * 1e-6) + phase;
  }
  [[nodiscard]] std::uint64_t system_time(Nanoseconds t) const {
    return static_cast<std::uint64_t>(std::llround(local(t))) + get<std::uint64_t>(reg::kSystemTimeOffset) -
           get<std::uint32_t>(reg::kSystemTimeDelay);
  }
};

class TestBus final : public Link {
 public:
  static constexpr Nanoseconds kHop = 500;

  TestBus(VirtualClock& clock, std::size_t slaves) : clock_(clock), slaves_(slaves) {
    for (std::size_t i = 0; i < slaves; ++i) {
      auto& slave = slaves_[i];
      slave.set<std::uint16_t>(reg::kFeatures, 0x000C);
      slave.set<std::uint16_t>(reg::kAlStatus, 1);
      // A line: port 0 and, but for the last one, port 1 are open and communicate.
      slave.set<std::uint16_t>(reg::kDlStatus, i + 1 < slaves ? 0x5A31 : 0x5611);
      slave.phase = static_cast<double>(i) * 1e6;
    }
  }

  TestSlave& slave(std::size_t i) { return slaves_.at(i); }
  /// The next so many frames do not come back.
  void lose(int frames) { lose_ = frames; }
  /// The next so many frames come back so much later, and nothing else meanwhile.
  void hold_back(int frames, Nanoseconds by) {
    held_ = frames;
    held_by_ = by;
  }
  std::vector<std::vector<std::uint8_t>> sent;  // filled when `record`
  bool record = false;
  std::size_t frames_sent = 0;
  std::function<void()> on_frame;  // before a frame is executed

  Status send(std::span<const std::uint8_t> frame) override {
    ++frames_sent;
    if (on_frame) on_frame();
    if (record) sent.emplace_back(frame.begin(), frame.end());
    if (lose_ > 0) {
      --lose_;
      return {};
    }
    std::vector<std::uint8_t> bytes(frame.begin(), frame.end());
    FrameReader reader(bytes);
    while (auto datagram = reader.next()) execute(*datagram);
    auto arrival = clock_.now() + 2 * kHop * static_cast<Nanoseconds>(slaves_.size());
    if (held_ > 0) {
      --held_;
      arrival += held_by_;
    }
    if (!returning_.empty()) arrival = std::max(arrival, returning_.back().first);
    returning_.push_back({arrival, std::move(bytes)});
    return {};
  }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    if (returning_.empty() || returning_.front().first > deadline) {
      clock_.advance_to(deadline);
      return ReceivedFrame{};
    }
    auto [time, bytes] = std::move(returning_.front());
    returning_.pop_front();
    clock_.advance_to(time);
    std::ranges::copy(bytes, buffer.begin());
    return ReceivedFrame{bytes.size(), time};
  }
  [[nodiscard]] LinkDescription describe() const override { return {"test", "simulated", {}, true}; }

 private:
  void execute(DatagramView& d) {
    for (std::size_t i = 0; i < slaves_.size(); ++i) {
      auto& slave = slaves_[i];
      if (!slave.present) continue;
      const auto command = d.header.command;
      if (is_logical(command)) {
        logical(slave, d);
        continue;
      }
      const auto adp = d.header.adp();
      bool match = is_broadcast(command) || (is_auto_increment(command) && adp == 0) ||
                   (is_fixed_address(command) && adp == slave.get<std::uint16_t>(reg::kStationAddress));
      const bool multiple_write = (command == Command::kArmw || command == Command::kFrmw) && !match;
      if (match || multiple_write) access(i, d, multiple_write);
      if (is_auto_increment(command) || is_broadcast(command)) {
        d.header.address = device_address(static_cast<std::uint16_t>(adp + 1), d.header.ado());
        d.store_header();
      }
    }
  }

  void access(std::size_t position, DatagramView& d, bool multiple_write) {
    auto& slave = slaves_[position];
    const auto ado = d.header.ado();
    if (!implemented(slave, ado)) return;
    const auto now = clock_.now() + kHop * static_cast<Nanoseconds>(position);
    const auto command = d.header.command;
    const bool write =
        multiple_write || command == Command::kApwr || command == Command::kFpwr || command == Command::kBwr;
    if (!write) {
      if (!before_read(slave, ado, d.data, now)) return;
      for (std::size_t n = 0; n < d.data.size(); ++n) {
        const auto value = slave.memory[ado + n];
        d.data[n] = command == Command::kBrd ? static_cast<std::uint8_t>(d.data[n] | value) : value;
      }
      after_read(slave, ado);
      d.set_wkc(static_cast<std::uint16_t>(d.wkc() + 1));
      return;
    }
    if (ado == slave.get<std::uint16_t>(reg::kSyncManager) && slave.has_mailbox && ado >= 0x1000) {
      if (!slave.answers.empty() && slave.answers.size() > 8) return;
    }
    if (write_hook(slave, position, ado, d.data, now)) {
      std::ranges::copy(d.data, slave.memory.begin() + ado);
    }
    d.set_wkc(static_cast<std::uint16_t>(d.wkc() + 1));
  }

  static bool implemented(const TestSlave& slave, std::uint16_t ado) {
    const bool system_time = ado >= reg::kSystemTime && ado < reg::kLatch0Control + 2;
    return slave.has_system_time || !system_time;
  }

  bool before_read(TestSlave& slave, std::uint16_t ado, std::span<const std::uint8_t> data, Nanoseconds now) {
    if (ado == reg::kSystemTime) slave.set(reg::kSystemTime, slave.system_time(now));
    if (ado == reg::kSiiControl && slave.sii_time > 0) {
      const auto idle = static_cast<std::uint16_t>(slave.get<std::uint16_t>(reg::kSiiControl) & 0x7FFF);
      slave.set<std::uint16_t>(reg::kSiiControl, now < slave.sii_ready ? idle | 0x8000U : idle);
    }
    const auto receive = slave.get<std::uint16_t>(reg::kSyncManager + 8);
    if (slave.has_mailbox && ado == reg::kSyncManager + 8 + 5) {
      const bool ready = !slave.answers.empty() && slave.mailbox_delay-- <= 0;
      slave.memory[ado] = ready ? SyncManager::kStatusMailboxFull : 0;
    }
    if (slave.has_mailbox && receive != 0 && ado == receive) {
      if (slave.answers.empty()) return false;
      auto answer = slave.answers.front();
      answer.resize(data.size());
      std::ranges::copy(answer, slave.memory.begin() + ado);
    }
    return true;
  }
  void after_read(TestSlave& slave, std::uint16_t ado) {
    if (slave.has_mailbox && ado >= 0x1000 && ado == slave.get<std::uint16_t>(reg::kSyncManager + 8)) {
      slave.answers.pop_front();
    }
  }

  /// False when the register is not plain memory.
  bool write_hook(TestSlave& slave, std::size_t position, std::uint16_t ado, std::span<const std::uint8_t> data,
                  Nanoseconds now) {
    if (ado == reg::kAlControl) {
      al_control(slave, data[0]);
    } else if (ado == reg::kSiiControl && data.size() >= 6) {
      if (now < slave.sii_ready) return false;  // blocked while busy
      slave.sii_ready = now + slave.sii_time;
      const auto word = load_le<std::uint32_t>(data.subspan(2));
      for (std::size_t n = 0; n < slave.sii_bytes; ++n) {
        const auto byte = word * 2 + n;
        slave.memory[reg::kSiiData + n] = byte < slave.sii.size() ? slave.sii[byte] : std::uint8_t{0xFF};
      }
      slave.set<std::uint16_t>(reg::kSiiControl, slave.sii_bytes == 8 ? 0x0040 : 0x0000);
      if (slave.shows_sii_address) slave.set(reg::kSiiAddress, word);
      return false;
    } else if (ado == reg::kReceiveTimePort0) {
      latch(slave, position);
      return false;
    } else if (ado == reg::kSystemTime && data.size() <= 8) {
      follow(slave, load_le<std::uint32_t>(data), now);
      return false;
    } else if (ado == reg::kSystemTime) {
      slave.set<std::uint64_t>(reg::kSystemTimeOffset, 0);
      slave.set<std::uint32_t>(reg::kSystemTimeDelay, 0);
      return false;
    } else if (slave.has_mailbox && ado >= 0x1000 && ado == slave.get<std::uint16_t>(reg::kSyncManager)) {
      mailbox(slave, data);
    }
    return true;
  }

  static void al_control(TestSlave& slave, std::uint8_t control) {
    const auto state = al_state_of(control);
    slave.requests.push_back(state);
    if (slave.refuse && slave.refuse->first == state) {
      slave.set<std::uint16_t>(reg::kAlStatus,
                               static_cast<std::uint16_t>(slave.get<std::uint16_t>(reg::kAlStatus) | kAlErrorFlag));
      slave.set<std::uint16_t>(reg::kAlStatusCode, slave.refuse->second);
      return;
    }
    const bool identify = slave.device_id && (control & 0x20) != 0;
    slave.set<std::uint16_t>(reg::kAlStatus, control & (identify ? 0x2F : 0x0F));
    slave.set<std::uint16_t>(reg::kAlStatusCode, identify ? *slave.device_id : 0);
  }

  void latch(TestSlave& slave, std::size_t position) {
    const auto out = clock_.now() + kHop * static_cast<Nanoseconds>(position);
    const auto back = clock_.now() + kHop * static_cast<Nanoseconds>(2 * (slaves_.size() - 1) - position);
    slave.set(reg::kReceiveTimePort0, static_cast<std::uint32_t>(std::llround(slave.local(out))));
    slave.set(reg::kReceiveTimePort1, static_cast<std::uint32_t>(std::llround(slave.local(back))));
    slave.set(reg::kReceiveTimeProcessingUnit, static_cast<std::uint64_t>(std::llround(slave.local(out))));
  }

  static void follow(TestSlave& slave, std::uint32_t received, Nanoseconds now) {
    const auto difference = static_cast<std::int32_t>(static_cast<std::uint32_t>(slave.system_time(now)) - received);
    slave.set(reg::kSystemTimeDifference, SystemTimeDifference::from_signed(difference).raw);
    slave.phase -= difference / 2.0;
  }

  static void mailbox(TestSlave& slave, std::span<const std::uint8_t> data) {
    const auto message = MailboxMessage::decode(data);
    if (!message) return;
    const auto request = coe::decode_request(message->data);
    if (!request) return;
    if (slave.emergency) answer(slave, *slave.emergency);
    slave.emergency.reset();
    std::visit([&](const auto& r) { serve(slave, r); }, *request);
  }
  static void answer(TestSlave& slave, const coe::Response& response) {
    MailboxMessage message;
    message.counter = 1;
    message.data = coe::encode(response);
    slave.answers.push_back(message.encode());
  }
  static std::uint32_t key(coe::ObjectAddress object) {
    return static_cast<std::uint32_t>(object.index << 8) | object.sub_index;
  }
  static void serve(TestSlave& slave, const coe::DownloadRequest& r) {
    if (r.object.index == 0x5FFF) return answer(slave, coe::Abort{r.object, 0x06020000});
    slave.transfer_object = r.object;
    slave.download = r.data;
    if (r.data.size() >= r.complete_size) finish_download(slave);
    answer(slave, coe::DownloadResponse{r.object});
  }
  static void serve(TestSlave& slave, const coe::DownloadSegmentRequest& r) {
    slave.download.insert(slave.download.end(), r.data.begin(), r.data.end());
    if (r.last) finish_download(slave);
    answer(slave, coe::DownloadSegmentResponse{r.toggle});
  }
  static void finish_download(TestSlave& slave) {
    slave.objects[key(slave.transfer_object)] = slave.download;
    slave.written.emplace_back(key(slave.transfer_object), slave.download);
  }
  static void serve(TestSlave& slave, const coe::UploadRequest& r) {
    const auto found = slave.objects.find(key(r.object));
    if (found == slave.objects.end()) return answer(slave, coe::Abort{r.object, 0x06020000});
    coe::UploadResponse response;
    response.object = r.object;
    response.expedited = found->second.size() <= 4;
    response.complete_size = static_cast<std::uint32_t>(found->second.size());
    const auto first = std::min<std::size_t>(found->second.size(), response.expedited ? 4 : 16);
    response.data.assign(found->second.begin(), found->second.begin() + static_cast<std::ptrdiff_t>(first));
    slave.upload.assign(found->second.begin() + static_cast<std::ptrdiff_t>(first), found->second.end());
    answer(slave, response);
  }
  static void serve(TestSlave& slave, const coe::UploadSegmentRequest& r) {
    const auto size = std::min<std::size_t>(slave.upload.size(), 20);
    coe::UploadSegmentResponse response{r.toggle, size == slave.upload.size(), {}};
    response.data.assign(slave.upload.begin(), slave.upload.begin() + static_cast<std::ptrdiff_t>(size));
    slave.upload.erase(slave.upload.begin(), slave.upload.begin() + static_cast<std::ptrdiff_t>(size));
    answer(slave, response);
  }
  static void serve(TestSlave&, const coe::Abort&) {}

  static void logical(TestSlave& slave, DatagramView& d) {
    const bool can_read = d.header.command != Command::kLwr, can_write = d.header.command != Command::kLrd;
    bool read = false, written = false;
    for (unsigned n = 0; n < 4; ++n) {
      const auto fmmu = Fmmu::decode(std::span(slave.memory).subspan(reg::fmmu(n)).first<Fmmu::kSize>());
      if (!fmmu.active) continue;
      for (std::uint32_t b = 0; b < fmmu.length; ++b) {
        const auto address = static_cast<std::uint64_t>(fmmu.logical_start) + b;
        if (address < d.header.address || address >= d.header.address + d.data.size()) continue;
        auto& wire = d.data[address - d.header.address];
        auto& memory = slave.memory[fmmu.physical_start + b];
        if (fmmu.write && can_write) {
          memory = wire;
          written = true;
        } else if (fmmu.read && can_read) {
          wire = memory;
          read = true;
        }
      }
    }
    const bool lrw = d.header.command == Command::kLrw;
    d.set_wkc(static_cast<std::uint16_t>(d.wkc() + (read ? 1 : 0) + (written ? (lrw ? 2 : 1) : 0)));
  }

  VirtualClock& clock_;
  std::vector<TestSlave> slaves_;
  std::deque<std::pair<Nanoseconds, std::vector<std::uint8_t>>> returning_;
  int lose_ = 0, held_ = 0;
  Nanoseconds held_by_ = 0;
};

}  // namespace syncline::test
