// SPDX-License-Identifier: Apache-2.0
#include "ui/models/eni_view.h"

#include <algorithm>
#include <utility>

#include "compare/line_changes.h"

namespace syncline::ui {
namespace {

void addChange(EniView& view, const LineChange& change) {
  const auto ours = static_cast<std::uint32_t>(change.right), theirs = static_cast<std::uint32_t>(change.left);
  switch (change.kind) {
    case LineChangeKind::kAdded:
      ++view.added;
      return view.rows.push_back({ours, EniRowKind::kAdded});
    case LineChangeKind::kRemoved:
      ++view.removed;
      return view.rows.push_back({theirs, EniRowKind::kRemoved});
    case LineChangeKind::kAltered:
      ++view.altered;
      view.rows.push_back({theirs, EniRowKind::kBefore});
      return view.rows.push_back({ours, EniRowKind::kAltered});
  }
}

}  // namespace

std::shared_ptr<const EniLines> EniLines::of(std::string text) {
  auto made = std::make_shared<EniLines>();
  made->text = std::move(text);
  made->lines = eni::lines_of(made->text);
  made->sections = eni::sections_of(made->lines);
  return made;
}

std::shared_ptr<EniView> EniView::of(std::shared_ptr<const EniLines> text, std::shared_ptr<const EniLines> before) {
  auto view = std::make_shared<EniView>();
  view->text = std::move(text);
  view->before = std::move(before);
  const auto& lines = view->text->lines;
  std::uint32_t next = 0;
  const auto same_until = [&](std::size_t end) {
    while (next < end) view->rows.push_back({next++, EniRowKind::kSame});
  };
  view->rows.reserve(lines.size());
  const auto changes = view->before != nullptr ? line_changes(view->before->lines, lines) : std::vector<LineChange>{};
  for (const auto& change : changes) {
    same_until(change.right);
    if (view->rows.empty() || view->rows.back().kind == EniRowKind::kSame)
      view->changes.push_back(static_cast<std::uint32_t>(view->rows.size()));
    addChange(*view, change);
    if (change.kind != LineChangeKind::kRemoved) ++next;
  }
  same_until(lines.size());
  for (const auto& row : view->rows) view->widest = std::max(view->widest, view->line(row).size());
  return view;
}

std::size_t EniView::line_at(std::size_t row) const {
  while (row < rows.size() && rows[row].ghost()) ++row;
  return row < rows.size() ? rows[row].line : text->lines.size();
}

/// Rows and their lines ascend, with ghosts between them.
std::size_t EniView::row_of(std::size_t line) const {
  std::size_t low = 0, high = rows.size();
  while (low < high) {
    const auto middle = low + (high - low) / 2;
    if (line_at(middle) < line || (rows[middle].ghost() && line_at(middle) == line)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return std::min(low, rows.empty() ? 0 : rows.size() - 1);
}

}  // namespace syncline::ui
