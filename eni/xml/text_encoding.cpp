// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/text_encoding.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>

#include "eni/xml/xml_text.h"
#include "reasons/because.h"
#include "support/utf8.h"

namespace syncline::eni {
namespace {

constexpr std::size_t kDeclaration = 300;  // bytes within which an XML declaration ends

struct Mark {
  std::string_view bytes;
  const char* name;
};
/// UTF-32 before UTF-16: the marks begin alike.
constexpr Mark kMarks[] = {{"\xEF\xBB\xBF", "UTF-8"},
                           {{"\xFF\xFE\0\0", 4}, "UTF-32LE"},
                           {{"\0\0\xFE\xFF", 4}, "UTF-32BE"},
                           {"\xFF\xFE", "UTF-16LE"},
                           {"\xFE\xFF", "UTF-16BE"}};

/// By the zeros around an ASCII character that begins a document without a mark: "<" or a space before it.
const char* wide_start(std::string_view text) {
  const auto begins = [&](std::size_t at) {
    return at < text.size() && std::string_view("< \t\r\n").find(text[at]) != std::string_view::npos;
  };
  const auto zeros = [&](std::size_t from, std::size_t count) {
    return text.size() >= from + count && text.substr(from, count).find_first_not_of('\0') == std::string_view::npos;
  };
  if (begins(0) && zeros(1, 3)) return "UTF-32LE";
  if (zeros(0, 3) && begins(3)) return "UTF-32BE";
  if (begins(0) && zeros(1, 1)) return "UTF-16LE";
  if (zeros(0, 1) && begins(1)) return "UTF-16BE";
  return nullptr;
}

/// Value of encoding="..." in the XML declaration, in capitals; "" = none.
std::string declared_encoding(std::string_view text) {
  if (!text.starts_with("<?xml")) return {};
  const auto declaration = text.substr(0, std::min(text.find("?>"), kDeclaration));
  auto at = declaration.find("encoding");
  if (at == std::string_view::npos) return {};
  at = declaration.find_first_of("\"'", at);
  if (at == std::string_view::npos) return {};
  const auto end = declaration.find(declaration[at], at + 1);
  if (end == std::string_view::npos) return {};
  std::string name(declaration.substr(at + 1, end - at - 1));
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return name;
}

/// Three bytes for a character, as UTF-8 has them: hardly by chance in another code.
bool has_long_utf8(std::string_view text) {
  return std::ranges::any_of(text, [](char c) { return (static_cast<std::uint8_t>(c) & 0xF0) == 0xE0; });
}

/// All that is not ASCII comes in pairs of GB 2312: two letters of a Western text side by side are rare, Chinese ones
/// are not.
bool looks_chinese(std::string_view text) {
  constexpr std::uint8_t kFirst = 0xA1, kLastRow = 0xF7, kLast = 0xFE;
  constexpr int kEnough = 4;
  int pairs = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (byte_at(text, i) < 0x80) continue;
    if (i + 1 == text.size()) return false;
    const std::uint8_t row = byte_at(text, i), cell = byte_at(text, i + 1);
    if (row < kFirst || row > kLastRow || cell < kFirst || cell > kLast) return false;
    ++pairs;
    ++i;
  }
  return pairs >= kEnough;
}

/// Of the bytes that are not ASCII more stand before an ASCII one than come in pairs: of codes whose letters have two
/// such bytes there is none so, and only rare letters of their supersets have an ASCII one for the second.
bool stand_alone(std::string_view text) {
  std::size_t alone = 0, pairs = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (byte_at(text, i) < 0x80) continue;
    const bool pair = i + 1 < text.size() && byte_at(text, i + 1) >= 0x80;
    ++(pair ? pairs : alone);
    if (pair) ++i;
  }
  return alone > pairs;
}

/// The name by which iconv converts what makers mean: supersets, since they name the page and write the larger one.
std::string widest(const std::string& declared) {
  if (declared == "GB2312" || declared == "GBK" || declared == "GB_2312-80" || declared == "CP936") return "GB18030";
  if (declared == "SHIFT_JIS" || declared == "SHIFT-JIS" || declared == "SJIS" || declared == "X-SJIS" ||
      declared == "WINDOWS-31J" || declared == "MS_KANJI")
    return "CP932";
  if (declared == "KS_C_5601-1987" || declared == "EUC-KR") return "CP949";
  if (declared == "ISO-8859-1" || declared == "LATIN1" || declared == "US-ASCII" || declared == "ASCII")
    return "CP1252";
  if (declared.starts_with("WINDOWS-")) return "CP" + declared.substr(8);
  return declared;
}

/// RAII over iconv_t; `this` is falsy where the system does not know the encoding.
class Converter {
 public:
  explicit Converter(const std::string& from) : handle_(::iconv_open("UTF-8", from.c_str())) {}
  ~Converter() {
    if (*this) ::iconv_close(handle_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;
  explicit operator bool() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  /// Bytes of `text` that were converted; all of them, or up to the first that cannot be.
  std::size_t convert(std::string_view text, std::string& out) const {
    out.resize(text.size() + text.size() / 2 + 16);
    char* from = const_cast<char*>(text.data());  // iconv() does not write to it
    std::size_t left = text.size(), written = 0;
    for (;;) {
      char* to = out.data() + written;
      std::size_t room = out.size() - written;
      const auto result = ::iconv(handle_, &from, &left, &to, &room);
      written = out.size() - room;
      if (result != static_cast<std::size_t>(-1) || errno != E2BIG) break;
      out.resize(out.size() * 2);
    }
    out.resize(written);
    return text.size() - left;
  }

 private:
  iconv_t handle_;
};

/// Every byte is a letter: five of windows-1252 have none there, and are control characters.
void from_latin1(std::string_view text, std::string& out) { (void)Converter("ISO-8859-1").convert(text, out); }

int line_at(std::string_view text, std::size_t at) {
  return static_cast<int>(1 + std::ranges::count(text.substr(0, at), '\n'));
}

std::string shown_name(const std::string& name) { return name == "CP1252" ? "ISO-8859-1 (windows-1252)" : name; }

std::optional<EncodingDoubt> doubt_of(const TextEncoding& encoding) {
  if (!encoding.guessed) return std::nullopt;
  const auto shown = shown_name(encoding.name);
  if (encoding.denied.empty())
    return EncodingDoubt{because("the text is not UTF-8, though it should be; read as {encoding}", shown)};
  if (encoding.name == "CP1252") {
    return EncodingDoubt{
        because("it names the encoding {name}, but its letters stand alone as Western ones do; read as {encoding}",
                encoding.denied, shown)};
  }
  return EncodingDoubt{
      because("it names the encoding {name}, but its letters come in pairs as those of GB 2312; read as {encoding}",
              encoding.denied, shown)};
}

}  // namespace

TextEncoding find_encoding(std::string_view text) {
  for (const Mark& mark : kMarks) {
    if (text.starts_with(mark.bytes)) {
      const bool broken = std::string_view(mark.name) == "UTF-8" && !is_utf8(text.substr(mark.bytes.size()));
      return {broken ? "CP1252" : mark.name, mark.bytes.size(), broken};
    }
  }
  if (const char* wide = wide_start(text)) return {wide, 0, false};
  const std::string declared = declared_encoding(text);
  const bool utf8 = is_utf8(text);
  const bool says_utf8 = declared.empty() || declared == "UTF-8" || declared == "UTF8";
  // "UTF-16" in a declaration that is written byte by byte is not true.
  const bool one_byte = !declared.starts_with("UTF-16") && !declared.starts_with("UTF-32") && declared != "UCS-2";
  if (utf8 && (says_utf8 || !one_byte || has_long_utf8(text))) return {};
  if (!says_utf8 && one_byte) {
    const std::string name = widest(declared);
    // Letters of two bytes each: many editors save UTF-8 and leave the declaration as it was.
    if (utf8 && name == "CP1252") return {};
    if (name == "CP1252" && looks_chinese(text)) return {"GB18030", 0, true, declared};
    if ((name == "GB18030" || name == "CP949") && stand_alone(text)) return {"CP1252", 0, true, declared};
    return {name, 0, false};
  }
  return {looks_chinese(text) ? "GB18030" : "CP1252", 0, true};
}

Result<DecodedText> decode_text(std::string_view text, std::string& buffer, const std::string& file_name) {
  const TextEncoding encoding = find_encoding(text);
  text.remove_prefix(encoding.mark);
  if (encoding.name == "UTF-8") return DecodedText{text};
  const Converter converter(encoding.name);
  if (!converter) {
    return fail(Error{
        .code = ErrorCode::kFileNotReadable,
        .detail =
            because("it is written in the encoding \"{name}\", which this system cannot convert; save it as UTF-8",
                    encoding.name),
        .file = file_name,
        .line = 1});
  }
  const std::size_t converted = converter.convert(text, buffer);
  if (converted == text.size()) return DecodedText{buffer, doubt_of(encoding)};
  const auto byte = fmt::format("{:02x}", byte_at(text, converted));
  const int line = line_at(text, converted);
  if (encoding.name == "CP1252") {
    from_latin1(text, buffer);
    const auto doubt = doubt_of(encoding);
    return DecodedText{buffer,
                       doubt ? *doubt
                             : EncodingDoubt{because("the byte 0x{byte} is no letter of the encoding {name}; read as a "
                                                     "control character",
                                                     byte, "windows-1252"),
                                             line}};
  }
  return fail(Error{.code = ErrorCode::kFileNotReadable,
                    .detail = because("it should be written in the encoding \"{name}\", to which the byte 0x{byte} "
                                      "does not belong; save it as UTF-8",
                                      encoding.name, byte),
                    .file = file_name,
                    .line = line});
}

}  // namespace syncline::eni
