// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/sample_range.h"

#include <algorithm>

#include "record/run_record.h"
#include "trace/sync_overview.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/time_view.h"

namespace syncline::ui {

SampleRange::SampleRange(const TimeView* view, const CursorSet* cursors, QWidget* parent)
    : QComboBox(parent), view_(view), cursors_(cursors) {
  addItems({tr("Range shown"), tr("Between the cursors"), tr("Since the figures were armed")});
}

SampleRange::Stretch SampleRange::of(const RunRecord& record) const {
  switch (chosen()) {
    case Range::kCursors: {
      if (!cursors_->both()) return {};
      const auto [first, last] = std::minmax({*cursors_->at(CursorSet::kA), *cursors_->at(CursorSet::kB)});
      return {first, last + 1};
    }
    case Range::kArmed:
      if (!record.overview().armed) return {};
      return {*record.overview().armed, record.samples().last_time() + 1};
    case Range::kShown:
      break;
  }
  return {view_->begin(), view_->end() + 1};
}

QString SampleRange::lack(const RunRecord& record) const {
  if (chosen() == Range::kCursors && !cursors_->both()) return tr("Set two cursors: keys A and B");
  if (chosen() == Range::kArmed && !record.overview().armed) return tr("Not armed: the machine has not been ready yet");
  return {};
}

}  // namespace syncline::ui
