// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/poll_choice.h"

#include <QLocale>

namespace syncline::ui {

PollChoice::PollChoice(const QString& on_demand, const QString& every, std::initializer_list<int> periods) {
  addItem(on_demand, 0);
  for (const int ms : periods) addItem(every.arg(QLocale().toString(ms / 1000.0)), ms);
}

void PollChoice::reset() {
  setCurrentIndex(0);
  last_.reset();
}

bool PollChoice::due(Nanoseconds now) {
  const auto period = currentData().toInt() * kMillisecond;
  if (period == 0) return false;
  if (last_ && now >= *last_ && now - *last_ < period) return false;
  last_ = now;
  return true;
}

}  // namespace syncline::ui
