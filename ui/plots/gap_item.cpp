// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/gap_item.h"

#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/plots/hatch.h"

namespace syncline::ui {

GapItem::GapItem() { setZ(5); }  // below everything

void GapItem::setSeries(const MinMaxSeries* series, Nanoseconds longest) {
  series_ = series;
  longest_ = longest;
  stretches_.clear();
}

void GapItem::prepare(const ColumnGrid& grid) {
  grid_ = grid;
  stretches_.clear();
  if (series_ == nullptr || series_->empty()) return;
  series_->columns(grid.origin, grid.end(), grid.width, columns_);
  // Before the first sample and behind the last there was no run.
  const auto first = static_cast<int>(std::max(0.0, grid.column_of(series_->first_time())));
  const auto last = static_cast<int>(std::min<double>(grid.columns, grid.column_of(series_->last_time())));
  const auto add = [&](int begin, int end) {
    if (static_cast<Nanoseconds>(end - begin) * grid.width > longest_) stretches_.push_back({begin, end});
  };
  int begin = -1;
  for (int i = first; i < std::min<int>(last, static_cast<int>(columns_.size())); ++i) {
    const bool valid = columns_[static_cast<std::size_t>(i)].valid;
    if (!valid && begin < 0) begin = i;
    if (valid && begin >= 0) add(std::exchange(begin, -1), i);
  }
  if (begin >= 0) add(begin, last);
}

void GapItem::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap&, const QRectF& canvas) const {
  const double width = (x.p2() - x.p1()) / std::max(grid_.columns, 1);
  for (const auto& stretch : stretches_) {
    const QRectF area(x.p1() + stretch.begin * width, canvas.top(), (stretch.end - stretch.begin) * width,
                      canvas.height());
    fillHatched(*painter, area, color_);
  }
}

}  // namespace syncline::ui
