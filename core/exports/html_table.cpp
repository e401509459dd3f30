// SPDX-License-Identifier: Apache-2.0
#include "exports/html_table.h"

#include <fmt/format.h>

#include "exports/markup_text.h"

namespace syncline::exports {

HtmlTable::HtmlTable(const std::vector<std::string_view>& titles) : html_("<table>\n<thead><tr>") {
  for (const auto title : titles) html_ += html_element("th", title);
  html_ += "</tr></thead>\n<tbody>\n";
}

HtmlTable::HtmlTable() : html_("<table class=\"facts\">\n<tbody>\n"), named_rows_(true) {}

HtmlTable& HtmlTable::row(const std::vector<std::string>& cells, std::string_view kind) {
  ++rows_;
  html_ += kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", markup_text(kind));
  for (std::size_t i = 0; i < cells.size(); ++i) html_ += html_element(named_rows_ && i == 0 ? "th" : "td", cells[i]);
  html_ += "</tr>\n";
  return *this;
}

std::string HtmlTable::end() const { return html_ + "</tbody>\n</table>\n"; }

std::string html_element(std::string_view name, std::string_view text) {
  return fmt::format("<{0}>{1}</{0}>", name, markup_text(text));
}

}  // namespace syncline::exports
