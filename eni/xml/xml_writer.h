// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace syncline::eni {

/// Writes indented XML into a string; same calls, same bytes. Text comes back from a reader exactly as it went in: line
/// ends, tabs and lone spaces are written as character references where a parser would change them.
class XmlWriter {
 public:
  /// `indent` stands before an element once for each level; `declaration` is the first line.
  explicit XmlWriter(std::string indent = "  ",
                     std::string_view declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")
      : out_(std::string(declaration) + "\n"), indent_(std::move(indent)) {}

  XmlWriter& open(std::string_view name);
  /// Of the element just opened, before its content.
  XmlWriter& attribute(std::string_view name, std::string_view value);
  /// Content of an element that has no child elements.
  XmlWriter& text(std::string_view value);
  XmlWriter& close();
  /// <name>value</name>
  XmlWriter& element(std::string_view name, std::string_view value);
  XmlWriter& comment(std::string_view words);

  /// The document; every element must be closed.
  [[nodiscard]] std::string take();

 private:
  void begin_child();
  void indent();

  std::string out_;
  std::string indent_;
  std::vector<std::string> path_;
  bool start_tag_open_ = false;
  bool has_text_ = false;
};

}  // namespace syncline::eni
