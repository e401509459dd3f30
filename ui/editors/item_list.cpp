// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/item_list.h"

#include <utility>

#include "config/project.h"
#include "settings/settings_table.h"
#include "ui/editors/page.h"

namespace syncline::ui {

RecordList itemList(const Page& page, const char* key, const QString& item, const QString& nothing, const char* fresh) {
  const auto& setting = settings::row(key);
  /// Whose items they are; nothing while the page shows another kind of node.
  const auto at = [&page, &setting]() -> std::optional<std::size_t> {
    if (!setting.of_slave()) return page.node() < 0 ? std::optional<std::size_t>(0) : std::nullopt;
    const bool there = page.node() >= 0 && std::cmp_less(page.node(), page.project().slaves.size());
    return there ? std::optional(static_cast<std::size_t>(page.node())) : std::nullopt;
  };
  RecordList list{
      .key = key, .item = item, .nothing = nothing, .ordered = true, .read = {}, .edits = {}, .fresh = {}, .place = {}};
  list.read = [&page, &setting, at] {
    Records records;
    const auto slave = at();
    if (!slave) return records;
    for (const auto& place : setting.items(page.project(), *slave))
      records.push_back(settings::text_of(setting, page.project(), place));
    return records;
  };
  list.edits = [key, at](const Records& before, const Records& after) {
    return itemEdits(key, at().value_or(0), before, after);
  };
  list.fresh = [text = std::string(fresh)](const Records&) { return text; };
  list.place = [&page, &setting, at](int row) -> std::optional<settings::Place> {
    const auto slave = at();
    if (!slave || row < 0 || std::cmp_greater_equal(row, setting.items(page.project(), *slave).size())) return {};
    return settings::Place{*slave, static_cast<std::uint32_t>(row)};
  };
  return list;
}

}  // namespace syncline::ui
