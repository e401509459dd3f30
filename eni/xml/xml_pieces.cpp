// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/xml_pieces.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "eni/xml/xml_limits.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {

/// Walks from tag to tag and copies what is no content of a piece. The lines of such a content stay as empty ones.
class XmlPieces::Splitter {
 public:
  Splitter(std::string_view text, IsPiece is_piece) : text_(text), is_piece_(is_piece) {}

  /// False where there is no piece, or start and end tags do not fit together: the outcome is of no use then.
  bool run() {
    for (at_ = text_.find('<'); at_ != std::string_view::npos; at_ = text_.find('<', at_)) {
      if (!markup()) return false;
    }
    if (pieces_.empty() || !open_.empty()) return false;
    keep_until(text_.size());
    return true;
  }

  [[nodiscard]] std::string take_frame() { return std::move(frame_); }
  [[nodiscard]] std::vector<Piece> take_pieces() { return std::move(pieces_); }

 private:
  /// By its second character first: most of a file are tags.
  bool markup() {
    switch (at_ + 1 < text_.size() ? text_[at_ + 1] : '>') {
      case '/':
        return end_tag();
      case '?':
        return skip_to("?>", 2);
      case '!':
        return no_element();
      default:
        return start_tag();
    }
  }

  bool no_element() {
    const auto rest = text_.substr(at_);
    if (rest.starts_with("<!--")) return skip_to("-->", 4);
    if (rest.starts_with("<![CDATA[")) return skip_to("]]>", 9);
    return skip_to(">", 2);
  }

  bool skip_to(std::string_view end, std::size_t from) {
    const auto found = text_.find(end, at_ + from);
    if (found == std::string_view::npos) return false;
    at_ = found + end.size();
    return true;
  }

  bool start_tag() {
    const std::size_t begin = at_;
    const std::size_t end = name_end(begin + 1);
    const auto name = text_.substr(begin + 1, end - begin - 1);
    if (name.empty()) return false;
    for (at_ = end; at_ < text_.size() && text_[at_] != '>'; ++at_) {
      if (text_[at_] == '<') return false;
      if (text_[at_] == '"' || text_[at_] == '\'') at_ = text_.find(text_[at_], at_ + 1);
      if (at_ == std::string_view::npos) return false;
    }
    if (at_ >= text_.size()) return false;
    ++at_;
    const bool closes_itself = text_[at_ - 2] == '/';
    if (!in_piece() && !open_.empty() && is_piece_(name, open_.back())) {
      line_ += static_cast<int>(std::count(text_.begin() + at(counted_), text_.begin() + at(begin), '\n'));
      counted_ = begin;
      pieces_.push_back({begin, at_, line_});
      if (!closes_itself) piece_depth_ = open_.size() + 1;
      keep_until(at_);
    }
    if (!closes_itself) open_.push_back(name);
    return true;
  }

  bool end_tag() {
    if (open_.empty()) return false;
    std::size_t end = name_end(at_ + 2);
    if (text_.substr(at_ + 2, end - at_ - 2) != open_.back()) return false;
    end = text_.find_first_not_of(" \t\r\n", end);
    if (end == std::string_view::npos || text_[end] != '>') return false;
    if (in_piece() && open_.size() == piece_depth_) {
      pieces_.back().end = end + 1;
      frame_.append(static_cast<std::size_t>(std::count(text_.begin() + at(kept_), text_.begin() + at(at_), '\n')),
                    '\n');
      kept_ = at_;
      piece_depth_ = 0;
    }
    open_.pop_back();
    at_ = end + 1;
    return true;
  }

  [[nodiscard]] std::size_t name_end(std::size_t at) const {
    const auto ends = [](char c) { return c == '>' || c == '/' || c == '<' || c == ' ' || (c >= '\t' && c <= '\r'); };
    while (at < text_.size() && !ends(text_[at])) ++at;
    return std::min(at, text_.size());
  }
  [[nodiscard]] bool in_piece() const { return piece_depth_ != 0; }
  static std::ptrdiff_t at(std::size_t place) { return static_cast<std::ptrdiff_t>(place); }
  void keep_until(std::size_t end) {
    frame_.append(text_.substr(kept_, end - kept_));
    kept_ = end;
  }

  std::string_view text_;
  IsPiece is_piece_;
  std::string frame_;
  std::vector<Piece> pieces_;
  std::vector<std::string_view> open_;  // elements around the present place
  std::size_t piece_depth_ = 0;         // 0 = outside of any
  std::size_t at_ = 0, kept_ = 0, counted_ = 0;
  int line_ = 1;  // at counted_
};

Result<XmlPieces> XmlPieces::parse(std::string_view text, const std::string& file_name, IsPiece is_piece) {
  XmlPieces out;
  out.file_name_ = file_name;
  out.converted_ = std::make_unique<std::string>();
  auto decoded = decode_text(text, *out.converted_, file_name);
  if (!decoded) return tl::unexpected(decoded.error());
  out.text_ = decoded->text;
  out.doubt_ = std::move(decoded->doubt);
  if (auto status = check_xml_limits(out.text_, file_name); !status) return tl::unexpected(status.error());
  Splitter splitter(out.text_, is_piece);
  if (splitter.run()) {
    const std::string frame = splitter.take_frame();
    if (auto document = parse_utf8(frame, file_name)) {
      out.document_ = std::move(*document);
      out.pieces_ = splitter.take_pieces();
      out.mark(is_piece);
      return out;
    }
  }
  auto document = parse_utf8(out.text_, file_name);
  if (!document) return tl::unexpected(document.error());
  out.document_ = std::move(*document);
  return out;
}

/// The n-th element that is a piece by its name is the n-th piece of the text.
void XmlPieces::mark(IsPiece is_piece) {
  std::size_t next = 0;
  const auto visit = [&](const auto& self, tinyxml2::XMLElement* parent) -> void {
    for (auto* e = parent->FirstChildElement(); e != nullptr && next < pieces_.size(); e = e->NextSiblingElement()) {
      if (is_piece(e->Name(), parent->Name())) {
        e->SetUserData(&pieces_[next++]);
      } else {
        self(self, e);
      }
    }
  };
  visit(visit, document_->RootElement());
}

/// What is wrong in a text is told as of the whole, of which a piece may be the second place only.
Error XmlPieces::error_of(const Piece& piece) const {
  if (const auto whole = parse_utf8(text_, file_name_); !whole) return whole.error();
  return Error{.code = ErrorCode::kXmlMalformed,
               .detail = because("an element is not complete"),
               .file = file_name_,
               .line = piece.line};
}

const tinyxml2::XMLElement* XmlPieces::whole(const tinyxml2::XMLElement& element) {
  const auto* place = static_cast<const Piece*>(element.GetUserData());
  if (place == nullptr) return &element;
  if (!piece_) piece_ = std::make_unique<tinyxml2::XMLDocument>();
  const auto text = text_.substr(place->begin, place->end - place->begin);
  if (piece_->Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS || piece_->RootElement() == nullptr) {
    if (!error_) error_ = error_of(*place);
    return nullptr;
  }
  set_first_line(*piece_, place->line);
  return piece_->RootElement();
}

Node XmlPieces::whole(const Node& element) {
  const auto* found = element ? whole(*element.element()) : nullptr;
  return found ? Node(found, element.reading()) : Node();
}

}  // namespace syncline::eni
