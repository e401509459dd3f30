// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace syncline {

/// A text that was made once, before the cycles run, and is handed on without allocating: copies share it.
class SharedText {
 public:
  SharedText() = default;
  explicit SharedText(std::string text) : text_(std::make_shared<const std::string>(std::move(text))) {}
  [[nodiscard]] const std::string& str() const {
    static const std::string kEmpty;
    return text_ ? *text_ : kEmpty;
  }
  bool operator==(const SharedText& other) const { return str() == other.str(); }

 private:
  std::shared_ptr<const std::string> text_;
};

}  // namespace syncline
