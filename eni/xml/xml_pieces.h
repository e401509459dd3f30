// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eni/xml/text_encoding.h"
#include "eni/xml/xml_reader.h"

/// Files of many large elements of one kind. A tree takes ten times the memory of its text and more; of an ESI with a
/// thousand devices one needs what stands around them and, one after the other, each of them.
namespace syncline::eni {

/// Whether an element is parsed on its own, by its name and that of the element around it.
using IsPiece = bool (*)(std::string_view element, std::string_view parent);

/// A document in whose tree the pieces stand with their attributes and without content; whole() parses one. Lines are
/// those of the file in both. Where the tags of a text do not fit together it is one tree, whose errors are told.
class XmlPieces {
 public:
  /// `text` outlives the object. Errors as of parse_xml(), those within the pieces excepted.
  [[nodiscard]] static Result<XmlPieces> parse(std::string_view text, const std::string& file_name, IsPiece is_piece);

  [[nodiscard]] const tinyxml2::XMLElement* root() const { return document_->RootElement(); }
  /// The element with its content; one that is no piece comes back as it is. Lives until the next piece is asked for.
  /// None, and error(), where the piece is no XML.
  [[nodiscard]] Node whole(const Node& element);
  [[nodiscard]] const tinyxml2::XMLElement* whole(const tinyxml2::XMLElement& element);
  /// As parse_xml() tells of the whole text: whoever finds it drops what he has read.
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  /// Of the encoding in which the text was read.
  [[nodiscard]] const std::optional<EncodingDoubt>& doubt() const { return doubt_; }

 private:
  struct Piece {
    std::size_t begin = 0, end = 0;  // in the text
    int line = 1;
  };
  class Splitter;

  XmlPieces() = default;
  void mark(IsPiece is_piece);
  [[nodiscard]] Error error_of(const Piece& piece) const;

  std::string file_name_;
  std::unique_ptr<std::string> converted_;  // what text_ may look into: stays where it is when this object moves
  std::string_view text_;
  std::vector<Piece> pieces_;  // the elements of the tree point to them
  XmlDocument document_, piece_;
  std::optional<Error> error_;
  std::optional<EncodingDoubt> doubt_;
};

}  // namespace syncline::eni
