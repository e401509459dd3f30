// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/open_element.h"

#include <vector>

namespace syncline::eni {
namespace {

constexpr auto kNone = std::string_view::npos;

bool ends_name(char c) { return c == '>' || c == '/' || c == '<' || c == ' ' || (c >= '\t' && c <= '\r'); }
bool begins_name(char c) { return !ends_name(c) && c != '-' && c != '.' && (c < '0' || c > '9'); }

class OpenElements {
 public:
  explicit OpenElements(std::string_view text) : text_(text) {}

  std::string_view innermost() {
    for (at_ = text_.find('<'); at_ != kNone && markup();) at_ = text_.find('<', at_);
    return open_.empty() ? std::string_view{} : open_.back();
  }

 private:
  /// Steps behind it; false where it does not end. By its second character first: most of a file are tags.
  bool markup() {
    switch (at_ + 1 < text_.size() ? text_[at_ + 1] : '>') {
      case '/':
        if (!open_.empty()) open_.pop_back();
        return skip_to(">", 2);
      case '?':
        return skip_to("?>", 2);
      case '!': {
        const auto rest = text_.substr(at_);
        if (rest.starts_with("<!--")) return skip_to("-->", 4);
        if (rest.starts_with("<![CDATA[")) return skip_to("]]>", 9);
        return skip_to(">", 2);
      }
      default:
        return start_tag();
    }
  }

  bool skip_to(std::string_view end, std::size_t from) {
    const auto found = text_.find(end, at_ + from);
    if (found == kNone) return false;
    at_ = found + end.size();
    return true;
  }

  bool start_tag() {
    const auto begin = at_ + 1;
    if (begin >= text_.size() || !begins_name(text_[begin])) return false;
    auto end = begin;
    while (end < text_.size() && !ends_name(text_[end])) ++end;
    const auto name = text_.substr(begin, end - begin);
    // Its ">" may also stand in the values of attributes.
    for (; end < text_.size() && text_[end] != '>'; ++end) {
      if (text_[end] != '"' && text_[end] != '\'') continue;
      end = text_.find(text_[end], end + 1);
      if (end == kNone) break;
    }
    const bool complete = end < text_.size();
    if (!complete || text_[end - 1] != '/') open_.push_back(name);
    at_ = end + 1;
    return complete;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string_view> open_;
};

}  // namespace

std::string_view open_element(std::string_view text) { return OpenElements(text).innermost(); }

}  // namespace syncline::eni
