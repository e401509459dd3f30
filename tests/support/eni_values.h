// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace syncline::test {

/// Where a number or bytes stand in the text of an ENI file.
struct EniValue {
  std::string element;  // in which
  std::size_t at = 0, length = 0;
};

/// Every element whose text is a number or bytes, in the order of the file.
inline std::vector<EniValue> values_of(const std::string& text) {
  std::vector<EniValue> found;
  for (std::size_t at = text.find('>'); at != std::string::npos; at = text.find('>', at + 1)) {
    const auto end = text.find_first_not_of("0123456789abcdef", at + 1);
    if (end == std::string::npos || end == at + 1 || text.compare(end, 2, "</") != 0) continue;
    found.push_back({text.substr(end + 2, text.find('>', end) - end - 2), at + 1, end - at - 1});
  }
  return found;
}

/// Every element with a text and nothing else in it, in the order of the file.
inline std::vector<EniValue> leaves_of(const std::string& text) {
  std::vector<EniValue> found;
  for (std::size_t at = text.find('>'); at != std::string::npos; at = text.find('>', at + 1)) {
    const auto end = text.find('<', at + 1);
    if (end == std::string::npos || end == at + 1 || text.compare(end, 2, "</") != 0) continue;
    found.push_back({text.substr(end + 2, text.find('>', end) - end - 2), at + 1, end - at - 1});
    // What stands between two end tags is no text of an element.
    if (text.find_first_not_of(" \t\r\n", at + 1) == end) found.pop_back();
  }
  return found;
}

}  // namespace syncline::test
