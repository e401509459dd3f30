// SPDX-License-Identifier: Apache-2.0
#include "exports/html_page.h"

#include "exports/html_table.h"

namespace syncline::exports {
namespace {

// Classes begin with "r-": those of the drawing hold for the whole page.
constexpr const char* kPageStyle = R"(<style>
@page { size: A4; margin: 14mm; }
:root { color-scheme: light; }
body { font: 10pt/1.4 'Inter', 'Segoe UI', 'DejaVu Sans', sans-serif; color: #1f2933; background: #ffffff;
  max-width: 190mm; margin: 0 auto; padding: 8mm 4mm; }
h1 { font-size: 18pt; margin: 0 0 4mm; }
h2 { font-size: 13pt; margin: 8mm 0 2mm; border-bottom: 1px solid #9aa5b1; break-after: avoid; }
table { border-collapse: collapse; width: 100%; font-size: 8.5pt; margin: 2mm 0; }
th, td { text-align: left; vertical-align: top; padding: 1mm 2mm 1mm 0; border-bottom: 1px solid #e4e7eb;
  overflow-wrap: anywhere; }
thead { display: table-header-group; }
thead th { border-bottom: 1px solid #52606d; overflow-wrap: normal; }
tr { break-inside: avoid; }
table.facts th { width: 55mm; font-weight: 600; color: #52606d; }
tr.r-error td:first-child { color: #b42318; font-weight: 700; }
tr.r-warning td:first-child { color: #93590c; font-weight: 700; }
svg { max-width: 100%; height: auto; }
p { margin: 1mm 0; }
</style>
)";

}  // namespace

HtmlPage::HtmlPage(std::string_view title, const std::string& head)
    : html_("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n") {
  html_ += html_element("title", title) + "\n" + kPageStyle + "</head>\n<body>\n" + html_element("h1", title) + "\n";
  html_ += head;
}

HtmlPage& HtmlPage::section(std::string_view name, const std::string& content) {
  html_ += html_element("h2", name) + "\n" + content;
  return *this;
}

std::string HtmlPage::end() const { return html_ + "</body>\n</html>\n"; }

}  // namespace syncline::exports
