// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace syncline::exports {

/// Puts a table of HTML together. All texts are escaped here.
class HtmlTable {
 public:
  explicit HtmlTable(const std::vector<std::string_view>& titles);
  /// With a title row on the left instead of above.
  HtmlTable();

  /// A cell for each title; the first of a table without them names its row. `kind`: class of the row, a word of ours.
  HtmlTable& row(const std::vector<std::string>& cells, std::string_view kind = {});
  [[nodiscard]] bool empty() const { return rows_ == 0; }
  /// The table with its end.
  [[nodiscard]] std::string end() const;

 private:
  std::string html_;
  std::size_t rows_ = 0;
  bool named_rows_ = false;
};

/// "<h2>", "<p>" ... around a text that is escaped.
[[nodiscard]] std::string html_element(std::string_view name, std::string_view text);

}  // namespace syncline::exports
