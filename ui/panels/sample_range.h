// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>

#include "support/types.h"

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CursorSet;
class TimeView;

/// Which samples count: those of the range that the plots show, between the cursors, or since the figures were armed.
class SampleRange final : public QComboBox {
  Q_OBJECT

 public:
  enum class Range { kShown, kCursors, kArmed };
  struct Stretch {
    Nanoseconds begin = 0, end = 0;  // [begin, end)
    bool operator==(const Stretch&) const = default;
  };

  SampleRange(const TimeView* view, const CursorSet* cursors, QWidget* parent = nullptr);
  /// Empty where there is none.
  [[nodiscard]] Stretch of(const RunRecord& record) const;
  /// What to do where there is none; empty where there is one.
  [[nodiscard]] QString lack(const RunRecord& record) const;

 private:
  [[nodiscard]] Range chosen() const { return static_cast<Range>(currentIndex()); }

  const TimeView* view_;
  const CursorSet* cursors_;
};

}  // namespace syncline::ui
