// SPDX-License-Identifier: Apache-2.0
#include "ui/models/count_history.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <utility>

#include "channels/slave_evidence.h"
#include "ui/text/units.h"

namespace syncline::ui {

void CountHistory::add(Nanoseconds time, std::vector<std::uint32_t> totals) {
  // Several times a second is more than anybody sees.
  if (kept_.size() > 1 && time - kept_[kept_.size() - 2].time < 100 * kMillisecond) kept_.pop_back();
  kept_.push_back({time, std::move(totals)});
  while (kept_.size() > 1 && time - kept_[1].time >= kSpan) kept_.pop_front();
}

std::uint32_t CountHistory::growth(std::size_t n) const {
  if (kept_.empty() || n >= kept_.back().totals.size() || n >= kept_.front().totals.size()) return 0;
  const auto now = kept_.back().totals[n], then = kept_.front().totals[n];
  return now > then ? now - then : 0;  // cleared in between
}

std::vector<std::uint32_t> portTotals(const std::array<PortErrors, 4>& ports) {
  std::vector<std::uint32_t> all;
  for (const auto& port : ports) {
    all.insert(all.end(), {port.invalid_frames, port.receive_errors, port.forwarded_errors, port.lost_links});
  }
  return all;
}

QString agoText(Nanoseconds age) {
  return QCoreApplication::translate("Counters", "%1 s ago")
      .arg(QLocale().toString(static_cast<double>(std::max<Nanoseconds>(age, 0)) / 1e9, 'f', 1));
}

QString growingText(std::uint32_t total, bool at_least, std::uint32_t growth) {
  auto text = countText(total);
  if (at_least) text = QCoreApplication::translate("Counters", "at least %1").arg(text);
  if (growth > 0) text += QCoreApplication::translate("Counters", " (+%1 in 10 s)").arg(countText(growth));
  return text;
}

}  // namespace syncline::ui
