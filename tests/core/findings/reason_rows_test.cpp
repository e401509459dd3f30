// SPDX-License-Identifier: Apache-2.0
// No sentence of an error is without its row in reason_words.h, and so without its translations.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "findings/reason_words.h"
#include "support/whole_file.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

/// With {} for each placeholder and what stands behind it without a letter between.
std::string bare_row(std::string_view text) {
  static const std::regex kHole(R"(\{[^{}]*\}+(\{[^{}]*\})*)");
  return std::regex_replace(std::string(text), kHole, "{}");
}

/// Without comments and characters in single quotes, which may hold a quotation mark.
std::string code_of(const std::string& source) {
  static const std::regex kCharacter(R"('(\\.|[^\\'\n])')"), kComment(R"((^|[ \n])//[^\n]*)");
  return std::regex_replace(std::regex_replace(source, kCharacter, "0"), kComment, "\n");
}

/// Where a call's arguments, or a field's value, end and part.
struct Arguments {
  std::vector<std::string> texts{};

  Arguments(const std::string& code, std::size_t at, bool of_call) {
    int depth = 0;
    std::string text;
    for (; at < code.size(); ++at) {
      const char c = code[at];
      if (c == '"') {
        const auto begin = at;
        for (++at; at < code.size() && code[at] != '"'; ++at) at += code[at] == '\\' ? 1U : 0U;
        text += code.substr(begin, at + 1 - begin);
        continue;
      }
      if (c == '(' || c == '{' || c == '[') ++depth;
      if (c == ')' || c == '}' || c == ']') --depth;
      if (depth < 0 || (c == ';' && depth == 0) || (c == ',' && depth == 0 && !of_call)) break;
      if (c == ',' && depth == 0) {
        texts.push_back(text);
        text.clear();
      } else {
        text += c;
      }
    }
    texts.push_back(text);
  }
};

/// The literals of an argument; those behind each other are one. What tr() says has its own translation.
std::vector<std::string> literals_of(const std::string& argument) {
  static const std::regex kLiteral(R"(((?:tr|QStringLiteral)\(\s*)?((?:"(?:[^"\\]|\\.)*"\s*)+))");
  static const std::regex kJoin(R"re(([^\\])"\s*")re"), kEscape(R"(\\(.))");
  std::vector<std::string> found;
  for (std::sregex_iterator at(argument.begin(), argument.end(), kLiteral), end; at != end; ++at) {
    if ((*at)[1].matched) continue;
    auto text = (*at)[2].str();
    text = text.substr(1, text.rfind('"') - 1);
    text = std::regex_replace(text, kJoin, "$1");
    found.push_back(std::regex_replace(text, kEscape, "$1"));
  }
  return found;
}

/// Names, bytes and formats are no sentences: these have two words.
bool is_sentence(const std::string& text) {
  static const std::regex kWords(R"([A-Za-z]{2,}[^A-Za-z]* .*[A-Za-z]{2,})");
  return std::regex_search(text, kWords);
}

/// The sentences that a source puts into Error::detail.
std::vector<std::string> reasons_in(const std::string& source) {
  static const std::regex kHead(
      R"((\.|->)?\b(fail|Error|bad|bad_value|fail_at|fail_in|refused|exceeded|malformed|malformed_information|broken|)"
      R"(unknown|other_kind|damaged|not_writable|none|protocol_error)(\(|\{)|\.(?:detail|why) = )");
  const auto code = code_of(source);
  std::vector<std::string> all;
  for (std::sregex_iterator at(code.begin(), code.end(), kHead), end; at != end; ++at) {
    const auto& head = *at;
    const Arguments arguments(code, static_cast<std::size_t>(head.position() + head.length()), head[2].matched);
    const bool of_error = !head[1].matched && (head[2] == "fail" || head[2] == "Error");
    if (of_error && arguments.texts.size() < 3) continue;  // no detail
    const auto& detail = of_error ? arguments.texts[2] : arguments.texts.back();
    for (const auto& text : literals_of(detail)) {
      if (is_sentence(text)) all.push_back(text);
    }
  }
  return all;
}

bool has_row(const std::string& sentence) {
  const auto text = bare_row(sentence);
  return std::ranges::any_of(words::kReasons, [&](std::string_view words) {
    const auto row = bare_row(words);
    return row == text || row == text + "{}" || row == "\"{}\" " + text;
  });
}

TEST(ReasonRows, TheSentencesOfASourceAreFound) {
  const auto found = reasons_in(
      "return fail(ErrorCode::kSii, \"slave 1\", \"one \" // why\n \"two\");\n"
      "return fail(ErrorCode::kSii, \"a subject\");\n"
      "error.detail = fmt::format(\"{} of {} \\\"x\\\" words\", a, b);\n"
      "if (c == '\"') node.fail(ErrorCode::kSii, \"of a node\");\n");
  const std::vector<std::string> wanted{"one two", "{} of {} \"x\" words", "of a node"};
  EXPECT_EQ(found, wanted);
  EXPECT_FALSE(has_row("a sentence that no table has"));
}

/// Not those of app/cli: they are said in the terminal only, which speaks English.
TEST(ReasonRows, EverySentenceOfAnErrorHasOne) {
  std::size_t seen = 0;
  for (const auto* folder : {"core", "eni", "ui", "app/composition", "app/gui"}) {
    const auto root = std::filesystem::path(test::source_dir()) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      const auto path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".h") continue;
      if (path.filename().string().ends_with("_words.h")) continue;
      for (const auto& sentence : reasons_in(read_whole_file(path.string(), std::size_t{1} << 24).value())) {
        ++seen;
        EXPECT_TRUE(has_row(sentence)) << path << ": no row of core/findings/*reason_words.h for: " << sentence;
      }
    }
  }
  EXPECT_GT(seen, 200U);
}

}  // namespace
}  // namespace syncline
