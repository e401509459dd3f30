// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/open_element.h"

#include <vector>

namespace syncline::eni {
namespace {

constexpr auto kNone = std::string_view::npos;

class OpenElements {
 public:
  explicit OpenElements(std::string_view text) : text_(text) {}

  std::string_view innermost() {
    for (at_ = text_.find('<'); at_ != kNone && markup();) at_ = text_.find('<', at_);
    return open_.empty() ? std::string_view{} : open_.back();
  }

 private:
  /// Steps behind it; false where it does not end.
  bool markup() {
    const auto rest = text_.substr(at_);
    if (rest.starts_with("<!--")) return skip_to("-->", 4);
    if (rest.starts_with("<![CDATA[")) return skip_to("]]>", 9);
    if (rest.starts_with("<?")) return skip_to("?>", 2);
    if (rest.starts_with("<!")) return skip_to(">", 2);
    if (!rest.starts_with("</")) return start_tag();
    if (!open_.empty()) open_.pop_back();
    return skip_to(">", 2);
  }

  bool skip_to(std::string_view end, std::size_t from) {
    const auto found = text_.find(end, at_ + from);
    if (found == kNone) return false;
    at_ = found + end.size();
    return true;
  }

  bool start_tag() {
    const auto begin = at_ + 1;
    const auto name = text_.substr(begin, text_.find_first_of(" \t\r\n/><", begin) - begin);
    if (name.find_first_of("-.0123456789") == 0 || name.empty()) return false;
    const auto end = end_of_tag(begin + name.size());
    if (end == kNone || text_[end - 1] != '/') open_.push_back(name);
    at_ = end + 1;
    return end != kNone;
  }

  /// Of its ">", which may also stand in the values of attributes.
  [[nodiscard]] std::size_t end_of_tag(std::size_t from) const {
    auto at = text_.find_first_of(">\"'", from);
    while (at != kNone && text_[at] != '>') {
      at = text_.find(text_[at], at + 1);
      if (at != kNone) at = text_.find_first_of(">\"'", at + 1);
    }
    return at;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string_view> open_;
};

}  // namespace

std::string_view open_element(std::string_view text) { return OpenElements(text).innermost(); }

}  // namespace syncline::eni
