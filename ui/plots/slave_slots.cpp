// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/slave_slots.h"

#include <algorithm>

#include "ui/plots/plot_colors.h"

namespace syncline::ui {
namespace {

constexpr double kClearlyWorse = 1.25;

}  // namespace

bool SlaveSlots::shows(int slave) const {
  return std::any_of(slots_.begin(), slots_.end(), [slave](const Slot& slot) { return slot.slave == slave; });
}

int SlaveSlots::freeColor(int slave) const {
  for (int i = 0; i < plot_colors::kTraceCount; ++i) {
    const int color = (slave + i) % plot_colors::kTraceCount;
    if (std::none_of(slots_.begin(), slots_.end(), [color](const Slot& slot) { return slot.color == color; }))
      return color;
  }
  return slave % plot_colors::kTraceCount;
}

bool SlaveSlots::update(const std::vector<double>& scores, int picked) {
  const auto before = slots_;
  const auto score = [&](int slave) { return scores[static_cast<std::size_t>(slave)]; };
  const auto known = [&](int slave) {
    return slave >= 0 && static_cast<std::size_t>(slave) < scores.size() && score(slave) >= 0;
  };
  std::erase_if(slots_, [&](const Slot& slot) { return !known(slot.slave); });
  const auto add = [this](int slave) { slots_.push_back({slave, freeColor(slave)}); };
  const auto mildest = [&] {
    return std::min_element(slots_.begin(), slots_.end(), [&](const Slot& a, const Slot& b) {
      if ((a.slave == picked) != (b.slave == picked)) return b.slave == picked;
      return score(a.slave) < score(b.slave);
    });
  };

  if (known(picked) && !shows(picked)) {
    if (slots_.size() >= count_) slots_.erase(mildest());
    add(picked);
  }
  std::vector<int> others;
  for (int slave = 0; slave < static_cast<int>(scores.size()); ++slave) {
    if (known(slave) && !shows(slave)) others.push_back(slave);
  }
  std::stable_sort(others.begin(), others.end(), [&](int a, int b) { return score(a) > score(b); });
  for (const int slave : others) {
    if (slots_.size() < count_) {
      add(slave);
    } else if (const auto weakest = mildest();
               weakest->slave != picked && score(slave) > kClearlyWorse * score(weakest->slave)) {
      slots_.erase(weakest);
      add(slave);
    } else {
      break;
    }
  }
  std::sort(slots_.begin(), slots_.end(), [](const Slot& a, const Slot& b) { return a.slave < b.slave; });
  return slots_ != before;
}

}  // namespace syncline::ui
