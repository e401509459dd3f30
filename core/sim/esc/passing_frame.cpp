// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/passing_frame.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "protocol/frame.h"
#include "protocol/registers.h"
#include "sim/registers/esc_ranges.h"

namespace syncline::sim {
namespace {

bool latches_port_times(const PassingDatagram& datagram) {
  return writes(datagram.command) && !is_logical(datagram.command) &&
         overlaps(datagram.ado, datagram.data.size(), reg::kReceiveTimePort0, 4);
}

bool reaches_clock(const PassingDatagram& datagram) {
  constexpr std::size_t kSize = 0x100;
  return !is_logical(datagram.command) && overlaps(datagram.ado, datagram.data.size(), reg::kReceiveTimePort0, kSize);
}

std::uint64_t key_of(const DatagramHeader& header) {
  constexpr unsigned kCommandBits = 8, kLengthBits = 16;
  const auto address = is_for_station(header.command) ? std::uint64_t{0} : std::uint64_t{header.address};
  return (address << kLengthBits | header.length) << kCommandBits | static_cast<std::uint8_t>(header.command);
}

/// ESCs know shapes by their numbers, whoever sends them frames.
std::uint64_t new_id() {
  static std::atomic<std::uint64_t> last{0};
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

}  // namespace

void PassingFrame::find_stations() {
  for (const auto station : stations_) wanted_[station / 64] = 0;
  stations_.clear();
  for (const auto& view : views_) {
    if (!is_for_station(view.header.command)) continue;
    const auto station = view.header.adp();
    stations_.push_back(station);
    wanted_[station / 64] |= std::uint64_t{1} << station % 64;
  }
}

/// A frame that comes for the first time may be the only one of its kind.
void PassingFrame::find_shape() {
  shape_ = nullptr;
  passed_ = {};
  keys_.clear();
  if (execution_ == Execution::kEach || for_single_slaves_ || views_.size() > FramePlan::kMostDatagrams) return;
  for (const auto& view : views_) keys_.push_back(key_of(view.header));
  // What goes to single slaves behind all else changes nothing for the others, and is another thing in each cycle.
  while (is_for_station(views_[keys_.size() - 1].header.command)) keys_.pop_back();
  const auto known = std::ranges::find(shapes_, keys_, &Shape::datagrams);
  if (known != shapes_.end()) {
    shape_ = &*known;
    return;
  }
  auto& shape = shapes_[next_shape_];
  shape = {new_id(), next_shape_, keys_};
  kinds_[next_shape_].assign(1, {});
  next_shape_ = static_cast<std::uint8_t>((next_shape_ + 1) % shapes_.size());
}

void PassingFrame::settle() {
  if (shape_ == nullptr) return;
  const auto& kinds = kinds_[shape_->place];
  unsigned slaves = 0;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const unsigned passed = std::exchange(passed_[kind], std::uint16_t{0});
    if (passed == 0) continue;
    slaves += passed;
    for (std::size_t i = 0; i < datagrams_.size(); ++i)
      datagrams_[i].wkc = static_cast<std::uint16_t>(datagrams_[i].wkc + passed * kinds[kind][i]);
  }
  if (slaves == 0) return;
  for (auto& datagram : datagrams_) datagram.adp = static_cast<std::uint16_t>(datagram.adp + slaves * datagram.step);
}

std::optional<std::uint8_t> PassingFrame::kind_of(const FramePlan::Counters& wkc) {
  auto& kinds = kinds_[shape_->place];
  const auto known = std::ranges::find(kinds, wkc);
  if (known == kinds.end() && kinds.size() == kMostKinds) return std::nullopt;
  const auto kind = static_cast<std::uint8_t>(known - kinds.begin());
  if (known == kinds.end()) kinds.push_back(wkc);
  return kind;
}

PassingFrame::Kind PassingFrame::arrive(std::span<std::uint8_t> bytes) {
  FrameReader reader(bytes, FrameReader::LengthField::kIgnored);
  views_.clear();
  datagrams_.clear();
  event_ = 0;
  while (const auto view = reader.next()) {
    const auto& header = view->header;
    const bool counts_slaves = is_auto_increment(header.command) || is_broadcast(header.command);
    views_.push_back(*view);
    datagrams_.push_back({header.command, header.circulating, header.adp(), header.ado(), header.address,
                          static_cast<std::uint16_t>(counts_slaves ? 1 : 0), view->wkc(), view->data});
  }
  if (reader.malformed()) return Kind::kMalformed;
  if (!reader.is_ethercat()) return Kind::kForeign;
  for_single_slaves_ =
      std::ranges::all_of(datagrams_, [](const auto& datagram) { return is_for_station(datagram.command); });
  takes_port_times_ = std::ranges::any_of(datagrams_, latches_port_times);
  touches_clock_ = std::ranges::any_of(datagrams_, reaches_clock);
  bytes_ = bytes;
  find_stations();
  find_shape();
  return Kind::kEtherCat;
}

void PassingFrame::leave() {
  settle();
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const auto& passed = datagrams_[i];
    auto& view = views_[i];
    view.header.irq = static_cast<std::uint16_t>(view.header.irq | event_);
    view.header.circulating = passed.circulating;
    if (passed.step != 0) view.header.address = device_address(passed.adp, passed.ado);
    view.set_wkc(passed.wkc);
    view.store_header();
  }
}

}  // namespace syncline::sim
