// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/xml_limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "reasons/because.h"

namespace syncline::eni {
namespace {

/// Walks from tag to tag without looking at what stands between. Ends quietly where the text stops being XML.
class LimitCheck {
 public:
  LimitCheck(std::string_view text, const std::string& file_name) : text_(text), file_name_(file_name) {}

  Status run() {
    for (at_ = text_.find('<'); at_ < text_.size(); at_ = text_.find('<', at_)) {
      start_ = at_;
      if (auto status = markup(); !status) return status;
    }
    const std::size_t parts = elements_ + attributes_ + others_;
    if (parts <= kManyParts || parts * kLeastBytesOfPart <= text_.size()) return {};
    return fail(Error{.code = ErrorCode::kFileLimit,
                      .detail = because("it has {count} elements, attributes and comments of less than {bytes} bytes "
                                        "each, as no tool writes them",
                                        parts, kLeastBytesOfPart),
                      .file = file_name_});
  }

 private:
  /// By its second character first: most of a file are tags.
  Status markup() {
    switch (at_ + 1 < text_.size() ? text_[at_ + 1] : '>') {
      case '/':
        --depth_;
        at_ = text_.find('>', at_ + 2);
        return {};
      case '?':
        return skip_to("?>", 2);
      case '!':
        return no_element(text_.substr(at_));
      default:
        return element();
    }
  }

  Status no_element(std::string_view rest) {
    ++others_;
    if (rest.starts_with("<!--")) return skip_to("-->", 4);
    if (rest.starts_with("<![CDATA[")) return skip_to("]]>", 9);
    const auto head = rest.substr(0, rest.find('>'));
    if (head.starts_with("<!ENTITY") || head.find('[') != std::string_view::npos) {
      return exceeded(because("it defines entities of its own, which are not read"));
    }
    return skip_to(">", 2);
  }

  Status element() {
    if (++elements_ > kMaxElements) return exceeded(because("more than {most} elements", kMaxElements));
    std::size_t attributes = 0;
    for (++at_; at_ < text_.size() && text_[at_] != '>'; ++at_) {
      const char c = text_[at_];
      if (c != '"' && c != '\'') continue;
      ++attributes;
      at_ = std::min(text_.find(c, at_ + 1), text_.size());
    }
    attributes_ += attributes;
    if (attributes > kMaxAttributesOfElement) {
      return exceeded(because("an element with more than {most} attributes", kMaxAttributesOfElement));
    }
    if (attributes_ > kMaxAttributes) return exceeded(because("more than {most} attributes", kMaxAttributes));
    const bool closes_itself = at_ < text_.size() && text_[at_ - 1] == '/';
    if (!closes_itself && ++depth_ > kMaxDepth) {
      return exceeded(because("elements are nested more than {most} deep", kMaxDepth));
    }
    return {};
  }

  Status skip_to(std::string_view end, std::size_t from) {
    const auto found = text_.find(end, std::min(at_ + from, text_.size()));
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
    return {};
  }

  [[nodiscard]] Status exceeded(Reason detail) const {
    const auto before = text_.substr(0, start_);
    const auto lines = std::ranges::count(before, '\n') + 1;
    return fail(Error{.code = ErrorCode::kFileLimit,
                      .detail = std::move(detail),
                      .file = file_name_,
                      .line = static_cast<int>(lines)});
  }

  std::string_view text_;
  const std::string& file_name_;
  std::size_t at_ = 0, start_ = 0, elements_ = 0, attributes_ = 0, others_ = 0;
  int depth_ = 0;
};

}  // namespace

Status check_xml_limits(std::string_view text, const std::string& file_name) {
  if (text.size() > kMaxFileBytes) {
    return fail(
        Error{.code = ErrorCode::kFileLimit,
              .detail = because("it has {size} MB, the limit is {limit} MB", text.size() >> 20, kMaxFileBytes >> 20),
              .file = file_name});
  }
  return LimitCheck(text, file_name).run();
}

}  // namespace syncline::eni
