// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/dc_read_back.h"

#include <span>

#include "protocol/registers.h"
#include "support/byte_order.h"
#include "ui/session/running_slave.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

// From 0x0980 to the end of 0x09A7, which every ESC with a SYNC unit answers in one piece.
constexpr std::uint16_t kBegin = reg::kCyclicUnitControl;
constexpr std::uint16_t kLength = reg::kSync0CycleTime + 8 - kBegin;

}  // namespace

DcReadBack::DcReadBack(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {}

void DcReadBack::forget() {
  workspace_.requests().drop(*this);
  station_.reset();
  registers_.reset();
  asked_ = false;
  next_ = 0;
}

void DcReadBack::tick(int slave, Nanoseconds now) {
  const auto running = runningSlave(workspace_, slave);
  if (!running || !running->present() || !workspace_.requests().possible()) return forget();
  if (station_ != running->config->station_address || now + kPeriod < next_) {
    forget();
    station_ = running->config->station_address;
  }
  if (asked_ || now < next_) return;
  next_ = now + kPeriod;
  asked_ = true;
  workspace_.requests().post(
      requests::RegisterRead{running->position, kBegin, kLength}, *this,
      [this](const RequestOutcome& outcome) { take(outcome); }, RequestUrgency::kBackground);
}

void DcReadBack::take(const RequestOutcome& outcome) {
  asked_ = false;
  registers_.reset();
  if (!outcome.ok() || outcome.answer.data.size() < kLength) return;
  const std::span<const std::uint8_t> bytes(outcome.answer.data);
  registers_ =
      Registers{load_le<std::uint16_t>(bytes), load_le<std::uint32_t>(bytes.subspan(reg::kSync0CycleTime - kBegin)),
                load_le<std::uint32_t>(bytes.subspan(reg::kSync0CycleTime - kBegin + 4))};
}

}  // namespace syncline::ui
