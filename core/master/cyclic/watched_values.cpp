// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/watched_values.h"

#include <algorithm>
#include <span>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "config/cyclic_frame.h"
#include "protocol/al_state.h"
#include "support/bits.h"

namespace syncline {
namespace {

/// 1 to 64 bits, which lie in the image.
std::uint64_t bits_at(std::span<const std::uint8_t> image, std::uint32_t offset, std::uint32_t size) {
  const std::size_t first = offset / 8;
  const std::size_t end = (std::size_t{offset} + size + 7) / 8;
  const unsigned shift = offset % 8;
  std::uint64_t value = 0;
  const auto bytes = image.subspan(first, end - first);
  for (std::size_t i = std::min<std::size_t>(bytes.size(), 8); i-- > 0;) value = value << 8 | bytes[i];
  value >>= shift;
  // The ninth byte of one that begins within a byte.
  if (bytes.size() == 9) value |= std::uint64_t{bytes[8]} << (64 - shift);
  return value & low_bits(size);
}

}  // namespace

void WatchedValues::watch(const WatchCommand& command) {
  list_ = command.list;
  count_ = std::min<std::size_t>(command.count, kMostWatched);
  for (std::size_t i = 0; i < count_; ++i) {
    auto& place = places_[i];
    place = {};
    place.what = command.places[i];
    const auto& [output, offset, size, slave] = place.what;
    const auto image = (output ? frames_.outputs() : frames_.inputs()).size();
    const auto end = std::uint64_t{offset} + size;
    if (size < 1 || size > 64 || end > image * std::uint64_t{8}) continue;
    const std::size_t first = offset / 8;
    const auto bytes = static_cast<std::size_t>((end + 7) / 8) - first;
    place.all_bytes = static_cast<std::uint16_t>((1U << bytes) - 1);
    const auto found = frames_.find_carriers(output, first, bytes, place.carriers);
    place.carrier_count = static_cast<std::uint8_t>(std::min(found, kMostCarriers));
  }
}

/// Each byte of it lies in a command that counts.
template <class Counts>
bool WatchedValues::covered(const Place& place, Counts counts) const {
  unsigned bytes = 0;
  for (std::size_t i = 0; i < place.carrier_count; ++i) {
    if (counts(place.carriers[i])) bytes |= place.carriers[i].bytes;
  }
  return place.all_bytes != 0 && bytes == place.all_bytes;
}

bool WatchedValues::exchanges(const Place& place) const {
  if (place.what.slave < 0) return true;
  if (static_cast<std::size_t>(place.what.slave) >= snapshot_.slaves.size()) return false;
  const auto& slave = snapshot_.slaves[static_cast<std::size_t>(place.what.slave)];
  return slave.present && has_process_data_communication(al_state_of(slave.al_status));
}

void WatchedValues::take_outputs() {
  for (std::size_t i = 0; i < count_; ++i) {
    auto& place = places_[i];
    if (!place.what.output) continue;
    const auto selected = [this](CyclicFrameSet::Carrier carrier) { return frames_.is_selected(carrier); };
    const auto sent = [this](CyclicFrameSet::Carrier carrier) { return frames_.is_sent(carrier); };
    if (covered(place, sent)) {
      place.sent = bits_at(frames_.outputs(), place.what.bit_offset, place.what.bit_size);
      place.was_sent = true;
    } else if (!covered(place, selected)) {
      place.was_sent = false;
    }
  }
}

void WatchedValues::fill(CycleSample& sample) const {
  sample.watch_list = list_;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& place = places_[i];
    const auto news = [this](CyclicFrameSet::Carrier carrier) { return frames_.has_news(carrier); };
    const bool known = place.what.output ? place.was_sent : covered(place, news) && exchanges(place);
    if (!known) continue;
    sample.watched_known = static_cast<std::uint16_t>(sample.watched_known | 1U << i);
    sample.watched[i] =
        place.what.output ? place.sent : bits_at(frames_.inputs(), place.what.bit_offset, place.what.bit_size);
  }
}

}  // namespace syncline
