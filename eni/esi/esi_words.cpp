// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_words.h"

#include <algorithm>

#include "config/esi_text.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_writer.h"
#include "reasons/because.h"

namespace syncline::eni {

std::vector<LocalizedText> read_texts(const Node& parent, const char* name) {
  std::vector<LocalizedText> texts;
  for (const Node& node : parent.children(name)) {
    texts.push_back({node.number<int>("LcId").value_or(Reading::kEnglish), node.trimmed()});
  }
  const bool says_no_more = texts.size() == 1 && texts.front().language == Reading::kEnglish;
  return says_no_more ? std::vector<LocalizedText>{} : texts;
}

EsiImage read_image(const Node& node) {
  EsiImage image;
  image.name = node.child("Image16x14").trimmed();
  image.file = node.child("ImageFile16x14").trimmed();
  const Node data = node.child("ImageData16x14");
  auto bytes = parse_hex_bytes(data.text());
  if (bytes) {
    image.data = std::move(*bytes);
  } else {
    data.warn(because("the picture is no hexadecimal data and is left out"));
  }
  return image;
}

void write_texts(XmlWriter& xml, std::string_view tag, const std::string& text,
                 const std::vector<LocalizedText>& texts) {
  if (texts.empty()) {
    xml.open(tag).attribute("LcId", "1033").text(text).close();
    return;
  }
  for (const LocalizedText& one : texts) {
    xml.open(tag).attribute("LcId", std::to_string(one.language)).text(one.text).close();
  }
}

void write_image(XmlWriter& xml, const EsiImage& image) {
  if (!image.name.empty()) xml.element("Image16x14", image.name);
  if (!image.file.empty()) xml.element("ImageFile16x14", image.file);
  if (!image.data.empty()) xml.element("ImageData16x14", hex_bytes(image.data));
}

}  // namespace syncline::eni
