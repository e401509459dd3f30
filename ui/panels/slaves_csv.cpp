// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>

#include "record/run_record.h"
#include "support/csv_field.h"
#include "ui/panels/slaves_view.h"
#include "ui/plots/series_csv.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/time_view.h"

namespace syncline::ui {

std::string SlavesView::csv() const {
  std::string text = "time_ns,time_utc,width_ns";
  std::vector<std::span<const float>> columns;
  const auto& cells = plot_->cells();
  if (record_ == nullptr) return text + '\n';
  for (const auto& row : plot_->rows()) {
    if (row.is_reference || row.slave >= cells.slaves()) continue;
    text +=
        ',' + csv_field(keyOf(*record_, {Signal::kSlaveDeviation, row.slave}) + ' ' + record_->slave_name(row.slave));
    columns.push_back(cells.row(row.slave));
  }
  text += '\n';
  const auto& grid = cells.grid();
  for (std::size_t i = 0; i < grid.columns; ++i) {
    const auto time = grid.origin + static_cast<Nanoseconds>(i) * grid.width;
    fmt::format_to(std::back_inserter(text), "{},{},{}", time - view_->origin(), iso_utc(time), grid.width);
    for (const auto& column : columns) {
      text += ',';
      if (column[i] >= 0) fmt::format_to(std::back_inserter(text), "{}", column[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace syncline::ui
