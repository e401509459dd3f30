// SPDX-License-Identifier: Apache-2.0
#include "ui/session/eeprom_repair.h"

#include <utility>

#include "ui/session/post.h"

namespace syncline::ui {

EepromRepair::EepromRepair(EepromRepairs repairs, QObject* parent) : QObject(parent), repairs_(std::move(repairs)) {}

EepromRepair::~EepromRepair() {
  cancel();
  if (worker_.joinable()) worker_.join();
}

std::vector<CutShortWrite> EepromRepair::pending() const {
  return repairs_.pending ? repairs_.pending() : std::vector<CutShortWrite>{};
}

void EepromRepair::start(const CutShortWrite& write, bool undo) {
  if (running_ || !repairs_.end) return;
  if (worker_.joinable()) worker_.join();
  running_ = true;
  cancelled_ = false;
  worker_ = std::thread([this, write, undo] {
    auto status = repairs_.end(write, undo, cancelled_);
    post(*this, [this, status = std::move(status)] { deliver(status); });
  });
}

Status EepromRepair::keep(const QString& link, int position, const std::vector<std::uint8_t>& before,
                          const std::vector<std::uint8_t>& after) const {
  return repairs_.keep ? repairs_.keep(link, position, before, after) : Status();
}

void EepromRepair::drop(const QString& link, int position) const {
  if (repairs_.drop) repairs_.drop(link, position);
}

void EepromRepair::deliver(const Status& status) {
  if (worker_.joinable()) worker_.join();
  running_ = false;
  if (status) {
    Q_EMIT finished();
  } else {
    Q_EMIT failed(status.error());
  }
}

}  // namespace syncline::ui
