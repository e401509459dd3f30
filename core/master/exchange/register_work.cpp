// SPDX-License-Identifier: Apache-2.0
#include "master/exchange/register_work.h"

#include <fmt/format.h>

namespace syncline {
namespace {

constexpr int kRegisterTries = 3;  // a slave that is there may miss a damaged frame

}  // namespace

void RegisterWork::begin(const SlaveAddress& slave, std::uint16_t address, std::size_t length) {
  slave_ = slave;
  address_ = address;
  length_ = length;
  done_ = 0;
  silences_ = 0;
  failure_.reset();
}

void RegisterWork::read(const SlaveAddress& slave, std::uint16_t address, std::size_t length,
                        std::vector<std::uint8_t>& into) {
  begin(slave, address, length);
  into_ = &into;
}

void RegisterWork::write(const SlaveAddress& slave, std::uint16_t address, std::span<const std::uint8_t> data) {
  begin(slave, address, data.size());
  into_ = nullptr;
  data_ = data;
}

void RegisterWork::give_up(const BriefError& why) { failure_ = why; }

Datagram* RegisterWork::next(Nanoseconds /*now*/) {
  if (over()) return nullptr;
  const auto part = std::span(bytes_).first(std::min(kMost, length_ - done_));
  std::ranges::fill(part, std::uint8_t{0});
  if (into_ == nullptr) std::ranges::copy(data_.subspan(done_, part.size()), part.begin());
  const auto place = static_cast<std::uint16_t>(address_ + done_);
  datagram_ = into_ == nullptr ? slave_.write(place, part) : slave_.read(place, part);
  return &datagram_;
}

void RegisterWork::take(Nanoseconds /*now*/) {
  if (over() || !datagram_.answered) return;  // the frame was lost: once more
  if (datagram_.wkc == 0) {
    if (++silences_ == kRegisterTries) failure_ = BriefError{.code = ErrorCode::kWorkingCounter, .expected = 1};
    return;
  }
  silences_ = 0;
  if (into_ != nullptr) into_->insert(into_->end(), datagram_.data.begin(), datagram_.data.end());
  done_ += datagram_.data.size();
}

Status RegisterWork::result() const {
  if (!failure_) return {};
  return fail(failure_->about(fmt::format("register 0x{:04X}", address_)));
}

}  // namespace syncline
