// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/xml_reader.h"

#include <fmt/format.h>

#include <utility>

#include "eni/xml/open_element.h"
#include "eni/xml/text_encoding.h"
#include "eni/xml/xml_limits.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

Reason malformed_reason(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return because("an end tag does not match its start tag");
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return because("an attribute is written wrongly");
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return because("an element is not complete");
    case tinyxml2::XML_ERROR_PARSING_TEXT:
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return because("a text does not end");
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return because("a comment does not end");
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return because("the XML declaration is wrong");
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return because("a <!...> section does not end");
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return because("the file is empty");
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return because("the elements are nested too deeply");
    default:
      return because("the text ends too early or is no XML");
  }
}

/// tinyxml2 tells the element only inside its sentence, "... Line number=3: XMLElement name=Sm", and not at all where
/// something within an element is wrong.
std::string element_of(const tinyxml2::XMLDocument& document, std::string_view text) {
  constexpr std::string_view kKey = "XMLElement name=";
  const std::string_view sentence = document.ErrorStr() ? document.ErrorStr() : "";
  const auto at = sentence.find(kKey);
  return std::string(at == std::string_view::npos ? open_element(text) : trim(sentence.substr(at + kKey.size())));
}

}  // namespace

void Reading::fail(ErrorCode code, int line, std::string subject, Reason detail) {
  if (error_) return;
  error_ = Error{.code = code, .subject = std::move(subject), .detail = std::move(detail), .file = file_, .line = line};
}

void Reading::fail(const Error& error) {
  if (!error_) error_ = error;
}

Reading Reading::of_file(const std::string& file) const {
  Reading part(file);
  part.warnings_ = warnings_;
  part.language_ = language_;
  if (file == file_) part.told_of_prefix_ = told_of_prefix_;
  return part;
}

void Reading::warn(int line, std::string element, Reason reason) {
  constexpr std::size_t kMost = 1000;  // a file that is wrong throughout shall not fill the memory with words
  if (warnings_ == nullptr || warnings_->size() >= kMost) return;
  warnings_->push_back({file_, line, std::move(element), std::move(reason)});
}

void Reading::warn_of_prefix(int line, std::string element) {
  if (!*told_of_prefix_) {
    warn(line, std::move(element), because("hexadecimal numbers of this file begin with 0x instead of #x"));
  }
  *told_of_prefix_ = true;
}

Node Node::child(const char* name) const {
  const auto* found = element_ ? element_->FirstChildElement(name) : nullptr;
  return found ? Node(found, *reading_) : Node();
}

Node Node::required(const char* name) const {
  const Node found = child(name);
  if (!found && element_)
    reading_->fail(ErrorCode::kXmlMissingElement, line(), name, because("in <{element}>", this->name()));
  return found;
}

std::vector<Node> Node::children(const char* name) const {
  std::vector<Node> nodes;
  if (element_ == nullptr) return nodes;
  for (const auto* e = element_->FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name)) {
    nodes.emplace_back(e, *reading_);
  }
  return nodes;
}

Node Node::localized(const char* name) const {
  Node first, neutral, english;
  for (const Node& node : children(name)) {
    const auto language = parse_number(node.attribute("LcId"));
    if (language == reading_->language()) return node;
    if (!english && language == Reading::kEnglish) english = node;
    if (!neutral && !node.has("LcId")) neutral = node;
    if (!first) first = node;
  }
  return english ? english : neutral ? neutral : first;
}

std::string Node::text() const {
  std::string all;
  if (element_ == nullptr) return all;
  for (const auto* node = element_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (const auto* part = node->ToText()) all += part->Value();
  }
  return all;
}

std::string Node::trimmed() const { return std::string(trim(text())); }

std::vector<std::uint8_t> Node::bytes() const {
  const auto value = text();
  auto parsed = parse_hex_bytes(value);
  if (!parsed && reading_ != nullptr && reading_->tolerant() && (parsed = parse_hex_bytes("0" + value))) {
    warn(because("\"{text}\" has an odd number of digits; a zero is put in front", trim(value)));
  }
  if (!parsed) bad_value(name(), {}, value, "\"{text}\" is no hexadecimal data");
  return parsed ? std::move(*parsed) : std::vector<std::uint8_t>{};
}

bool Node::boolean() const {
  const auto value = parse_bool(text());
  if (!value && element_) bad_value(name(), {}, text(), "\"{text}\" is neither true nor false");
  return value.value_or(false);
}

std::string Node::attribute(const char* name) const {
  const char* value = element_ ? element_->Attribute(name) : nullptr;
  return value ? value : "";
}

std::optional<bool> Node::boolean(const char* attribute_name) const {
  if (!has(attribute_name)) return std::nullopt;
  const auto value = parse_bool(attribute(attribute_name));
  if (!value) bad_value(name(), attribute_name, attribute(attribute_name), "\"{text}\" is neither true nor false");
  return value;
}

void Node::fail(ErrorCode code, Reason detail) const {
  if (element_) reading_->fail(code, line(), std::string(name()), std::move(detail));
}

void Node::warn(Reason reason) const {
  if (element_) reading_->warn(line(), std::string(name()), std::move(reason));
}

std::optional<std::int64_t> Node::sloppy_number(std::string_view element, std::string_view attribute,
                                                std::string_view value) const {
  if (reading_ == nullptr || !reading_->tolerant()) return std::nullopt;
  const auto number = parse_sloppy_number(value);
  if (number) {
    auto subject = attribute.empty() ? std::string(element) : fmt::format("{}@{}", element, attribute);
    reading_->warn(line(), std::move(subject), because("\"{text}\" is read as {value}", trim(value), *number));
  }
  return number;
}

void Node::bad_value(std::string_view element, std::string_view attribute, std::string_view value,
                     ReasonRow<1> problem) const {
  constexpr std::size_t kShown = 40;
  if (reading_ == nullptr) return;
  std::string shown(trim(value));
  if (shown.size() > kShown) shown = shown.substr(0, kShown) + "...";
  auto subject = attribute.empty() ? std::string(element) : fmt::format("{}@{}", element, attribute);
  reading_->fail(ErrorCode::kXmlBadValue, line(), std::move(subject), because(problem, shown));
}

void set_first_line(tinyxml2::XMLDocument& document, int line) {
  document.SetUserData(reinterpret_cast<void*>(static_cast<std::intptr_t>(line - 1)));
}

int line_of(const tinyxml2::XMLElement& element) {
  return element.GetLineNum() + static_cast<int>(reinterpret_cast<std::intptr_t>(element.GetDocument()->GetUserData()));
}

Result<XmlDocument> parse_utf8(std::string_view text, const std::string& file_name) {
  auto document = std::make_unique<tinyxml2::XMLDocument>();
  const auto status = document->Parse(text.data(), text.size());
  if (status != tinyxml2::XML_SUCCESS) {
    const auto element = element_of(*document, text);
    return fail(Error{.code = ErrorCode::kXmlMalformed,
                      .subject = element,
                      .detail = element.empty() ? malformed_reason(status)
                                                : because("{reason} (<{element}>)", malformed_reason(status), element),
                      .file = file_name,
                      .line = document->ErrorLineNum()});
  }
  if (document->RootElement() == nullptr) {
    return fail(Error{
        .code = ErrorCode::kXmlMalformed, .detail = because("there is no element"), .file = file_name, .line = 1});
  }
  return document;
}

Result<XmlDocument> parse_xml(std::string_view text, const std::string& file_name) {
  std::string converted;
  const auto utf8 = decode_text(text, converted, file_name);
  if (!utf8) return tl::unexpected(utf8.error());
  if (auto status = check_xml_limits(utf8->text, file_name); !status) return tl::unexpected(status.error());
  return parse_utf8(utf8->text, file_name);
}

Result<XmlDocument> load_xml(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return parse_xml(*text, path);
}

}  // namespace syncline::eni
