// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace syncline {
struct EsiImage;
struct LocalizedText;
}  // namespace syncline

/// Names in several languages and pictures, as devices, groups, modules and slots carry them.
namespace syncline::eni {

class Node;
class XmlWriter;

/// All children `name`; empty when there is but one and it is English, which the plain name says as well.
[[nodiscard]] std::vector<LocalizedText> read_texts(const Node& parent, const char* name);
/// Image16x14, ImageFile16x14 or ImageData16x14 among the children; a picture that cannot be read is a warning.
[[nodiscard]] EsiImage read_image(const Node& node);

/// `texts`, or `text` in English when there are none.
void write_texts(XmlWriter& xml, std::string_view tag, const std::string& text,
                 const std::vector<LocalizedText>& texts);
void write_image(XmlWriter& xml, const EsiImage& image);

}  // namespace syncline::eni
