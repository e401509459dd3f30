// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/result.h"

namespace syncline::eni {

/// Collects the first error of a file; the readers go on with defaults, so that they need no error path of their own.
class EniReadContext {
 public:
  explicit EniReadContext(std::string file) : file_(std::move(file)) {}
  void report(ErrorCode code, int line, std::string_view element, std::string detail = {});
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::optional<Error> error_;
};

/// An element of an ENI file, or none: every access on a missing element gives the default.
class EniElement {
 public:
  EniElement(const tinyxml2::XMLElement* element, EniReadContext& context) : element_(element), context_(&context) {}

  explicit operator bool() const { return element_ != nullptr; }
  [[nodiscard]] int line() const { return element_ ? element_->GetLineNum() : 0; }
  [[nodiscard]] std::string_view name() const { return element_ ? element_->Name() : ""; }
  [[nodiscard]] EniElement child(const char* name) const;
  /// The child; a missing one is an error that names it.
  [[nodiscard]] EniElement required(const char* name) const;
  [[nodiscard]] std::vector<EniElement> children(const char* name) const;
  [[nodiscard]] std::vector<EniElement> children() const;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string attribute(const char* name) const;
  [[nodiscard]] std::string text_of(const char* child_name) const { return child(child_name).text(); }

  /// Decimal, "#x.." or "0x..", negative where a tool wrote a large unsigned number as xs:int. Anything else, or a number
  /// that does not fit T either way, is kXmlBadValue.
  template <std::integral T>
  [[nodiscard]] T number() const {
    return static_cast<T>(integer(text(), std::numeric_limits<T>::max(), sizeof(T) * 8));
  }
  template <std::integral T>
  [[nodiscard]] T number_of(const char* child_name, T otherwise = 0) const {
    const EniElement found = child(child_name);
    return found ? found.number<T>() : otherwise;
  }
  template <std::integral T>
  [[nodiscard]] std::optional<T> optional_number_of(const char* child_name) const {
    const EniElement found = child(child_name);
    return found ? std::optional(found.number<T>()) : std::nullopt;
  }
  template <std::integral T>
  [[nodiscard]] std::optional<T> number_attribute(const char* name) const {
    const std::string value = attribute(name);
    return value.empty() ? std::nullopt
                         : std::optional(static_cast<T>(integer(value, std::numeric_limits<T>::max(), sizeof(T) * 8)));
  }
  [[nodiscard]] bool boolean() const { return to_boolean(text()); }
  [[nodiscard]] bool boolean_of(const char* child_name) const { return child(child_name).boolean(); }
  [[nodiscard]] bool boolean_attribute(const char* name) const { return to_boolean(attribute(name)); }
  /// xs:hexBinary; "0x" in front and ':' or '-' between bytes are tolerated.
  [[nodiscard]] std::vector<std::uint8_t> bytes() const;

  void report(ErrorCode code, std::string detail) const { context_->report(code, line(), name(), std::move(detail)); }

 private:
  [[nodiscard]] std::int64_t integer(const std::string& value, std::uint64_t maximum, unsigned bits) const;
  [[nodiscard]] bool to_boolean(const std::string& value) const;

  const tinyxml2::XMLElement* element_;
  EniReadContext* context_;
};

}  // namespace syncline::eni
