// SPDX-License-Identifier: Apache-2.0
#include "sim/passing_frame.h"

#include <algorithm>

#include "protocol/registers.h"
#include "sim/esc_ranges.h"

namespace syncline::sim {
namespace {

bool latches_port_times(const PassingDatagram& datagram) {
  return writes(datagram.command) && !is_logical(datagram.command) &&
         overlaps(datagram.ado, datagram.data.size(), reg::kReceiveTimePort0, 4);
}

}  // namespace

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
  for_single_slaves_ = std::ranges::all_of(datagrams_, [](const PassingDatagram& datagram) {
    return is_fixed_address(datagram.command) && datagram.command != Command::kFrmw;
  });
  takes_port_times_ = std::ranges::any_of(datagrams_, latches_port_times);
  return Kind::kEtherCat;
}

void PassingFrame::leave() {
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
