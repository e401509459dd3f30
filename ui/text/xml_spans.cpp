// SPDX-License-Identifier: Apache-2.0
#include "ui/text/xml_spans.h"

#include <QChar>
#include <QLatin1String>
#include <algorithm>

namespace syncline::ui {
namespace {

class XmlLine {
 public:
  explicit XmlLine(QStringView line) : line_(line) {}

  std::vector<XmlSpan> spans() {
    while (at_ < line_.size()) {
      if (line_.sliced(at_).startsWith(QLatin1String("<!"))) {
        const bool comment = line_.sliced(at_).startsWith(QLatin1String("<!--"));
        const auto end = line_.indexOf(comment ? QLatin1String("-->") : QLatin1String("]]>"), at_);
        take(end < 0 ? line_.size() : end + 3, comment ? XmlPiece::kComment : XmlPiece::kText);
      } else if (line_[at_] == u'<') {
        tag();
      } else {
        const auto end = line_.indexOf(u'<', at_);
        take(end < 0 ? line_.size() : end, XmlPiece::kText);
      }
    }
    return std::move(spans_);
  }

 private:
  void take(qsizetype end, XmlPiece piece) {
    auto first = at_;
    while (first < end && line_[first].isSpace()) ++first;
    if (first < end) spans_.push_back({first, end - first, piece});
    at_ = end;
  }
  template <class Stop>
  [[nodiscard]] qsizetype until(Stop stop) const {
    auto end = at_;
    while (end < line_.size() && !stop(line_[end])) ++end;
    return end;
  }
  static bool endsName(QChar c) { return c.isSpace() || c == u'>' || c == u'/' || c == u'=' || c == u'?'; }

  void tag() {
    const bool marked = at_ + 1 < line_.size() && (line_[at_ + 1] == u'/' || line_[at_ + 1] == u'?');
    take(at_ + (marked ? 2 : 1), XmlPiece::kPunctuation);
    take(until(endsName), XmlPiece::kElement);
    while (at_ < line_.size() && line_[at_] != u'>') {
      if (line_[at_].isSpace()) {
        ++at_;
      } else if (line_[at_] == u'"' || line_[at_] == u'\'') {
        const auto end = line_.indexOf(line_[at_], at_ + 1);
        take(end < 0 ? line_.size() : end + 1, XmlPiece::kValue);
      } else if (endsName(line_[at_])) {
        take(at_ + 1, XmlPiece::kPunctuation);
      } else {
        take(until(endsName), XmlPiece::kAttribute);
      }
    }
    if (at_ < line_.size()) take(at_ + 1, XmlPiece::kPunctuation);
  }

  QStringView line_;
  qsizetype at_ = 0;
  std::vector<XmlSpan> spans_;
};

}  // namespace

std::vector<XmlSpan> xmlSpans(QStringView line) { return XmlLine(line).spans(); }

}  // namespace syncline::ui
