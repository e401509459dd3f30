// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace syncline::exports {

/// One HTML file in English out of sections: no scripts, nothing from elsewhere, light, for A4. Texts are escaped here,
/// but not what is HTML already.
class HtmlPage {
 public:
  /// `head`: HTML below the title.
  HtmlPage(std::string_view title, const std::string& head);
  /// `content`: HTML.
  HtmlPage& section(std::string_view name, const std::string& content);
  /// The page with its end.
  [[nodiscard]] std::string end() const;

 private:
  std::string html_;
};

}  // namespace syncline::exports
