// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringView>
#include <vector>

namespace syncline::ui {

enum class XmlPiece : unsigned char { kPunctuation, kElement, kAttribute, kValue, kText, kComment };

/// A stretch of a line of XML, in characters.
struct XmlSpan {
  qsizetype start = 0, length = 0;
  XmlPiece piece = XmlPiece::kText;
  bool operator==(const XmlSpan&) const = default;
};

/// What stands in a line that holds whole tags, as those that we write do. White space belongs to none.
[[nodiscard]] std::vector<XmlSpan> xmlSpans(QStringView line);

}  // namespace syncline::ui
