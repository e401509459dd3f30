// SPDX-License-Identifier: Apache-2.0
#include "master/slave_watch.h"

#include <utility>

#include "protocol/dc_registers.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::size_t kAlReadsPerCycle = 16;

}  // namespace

SlaveWatch::SlaveWatch(RunState& run) : run_(run), al_(run.config().slaves.size()), next_al_(al_.size()) {
  for (std::size_t i = 0; i < al_.size(); ++i) {
    al_[i].datagram = {Command::kFprd, device_address(run.config().slaves[i].station_address, reg::kAlStatus),
                       al_[i].bytes};
  }
  deviation_ = {Command::kFprd, 0, deviation_bytes_};
  all_ = {Command::kBrd, device_address(0, reg::kSystemTimeDifference), all_bytes_};
}

void SlaveWatch::observe_broadcast(std::uint16_t al_status, std::uint16_t wkc) {
  const bool changed = last_status_ != al_status || last_wkc_ != wkc;
  last_status_ = al_status;
  last_wkc_ = wkc;
  if (changed) refresh_al_status();
}

void SlaveWatch::add_to(PendingFrame& frame, bool read_deviation_of_all) {
  asked_deviation_.reset();
  asked_all_ = false;
  if (!dc_slaves_.empty()) {
    const auto position = dc_slaves_[next_dc_ % dc_slaves_.size()];
    deviation_bytes_.fill(0);
    deviation_.address =
        device_address(run_.config().slaves[position].station_address, reg::kSystemTimeDifference);
    if (frame.add(deviation_)) {
      asked_deviation_ = position;
      ++next_dc_;
    }
  }
  if (read_deviation_of_all) {
    all_bytes_.fill(0);
    asked_all_ = frame.add(all_);
  }
  add_al_status(frame);
}

void SlaveWatch::add_al_status(PendingFrame& frame) {
  asked_begin_ = asked_end_ = next_al_;
  while (next_al_ < al_.size() && asked_end_ - asked_begin_ < kAlReadsPerCycle) {
    al_[next_al_].bytes.fill(0);
    if (!frame.add(al_[next_al_].datagram)) break;
    asked_end_ = ++next_al_;
  }
}

std::optional<std::uint32_t> SlaveWatch::take(Nanoseconds time, CycleSample& sample) {
  take_deviation(time, sample);
  take_al_status(time);
  if (!std::exchange(asked_all_, false) || !all_.done()) return std::nullopt;
  return SystemTimeDifference{load_le<std::uint32_t>(all_bytes_)}.magnitude();
}

void SlaveWatch::take_deviation(Nanoseconds time, CycleSample& sample) {
  if (!asked_deviation_ || !deviation_.done()) return;
  const auto deviation = SystemTimeDifference{load_le<std::uint32_t>(deviation_bytes_)}.signed_value();
  auto& slave = run_.snapshot.slaves[*asked_deviation_];
  slave.deviation_ns = deviation;
  slave.deviation_valid = true;
  slave.deviation_time = time;
  sample.slave_position = static_cast<std::int16_t>(*asked_deviation_);
  sample.slave_deviation_ns = deviation;
}

void SlaveWatch::take_al_status(Nanoseconds time) {
  if (asked_begin_ == asked_end_) return;
  for (std::size_t i = asked_begin_; i < asked_end_; ++i) {
    auto& reading = al_[i];
    if (!reading.datagram.answered) {
      next_al_ = asked_begin_;  // the frame was lost: once more
      return;
    }
    run_.set_present(i, reading.datagram.wkc > 0, time);
    if (reading.datagram.wkc == 0) continue;
    const std::span<const std::uint8_t> bytes(reading.bytes);
    run_.set_al_status(i, load_le<std::uint16_t>(bytes), load_le<std::uint16_t>(bytes.subspan(4)), time);
  }
  if (next_al_ == al_.size()) run_.update_master_state(time);
}

}  // namespace syncline
