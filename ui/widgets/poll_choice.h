// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <initializer_list>
#include <optional>

#include "support/types.h"

namespace syncline::ui {

/// How often something is read: on demand, or again and again.
class PollChoice final : public QComboBox {
 public:
  /// `every`: "Every %1 s"; periods in milliseconds, ascending.
  PollChoice(const QString& on_demand, const QString& every, std::initializer_list<int> periods);
  /// Back to on demand: it is another slave, or another run.
  void reset();
  /// Whether it is time again; the next period begins at `now` then. A clock that has begun anew is as good as another.
  [[nodiscard]] bool due(Nanoseconds now);

 private:
  std::optional<Nanoseconds> last_;
};

}  // namespace syncline::ui
