// SPDX-License-Identifier: Apache-2.0
// Files that are made to hurt, to all three readers: a clear error with file and line, in bounded time and memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <ctime>
#include <filesystem>
#include <fstream>

#include "compile/compile.h"
#include "eni/esi/esi_reader.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "eni/xml/xml_limits.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"
#include "eni/xml/xml_writer.h"
#include "findings/error_text.h"
#include "support/utf8.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

using ::testing::HasSubstr;

struct Reader {
  const char* name;
  const char* root;
  Error (*read)(const std::string& text);  // kCancelled when the text was read without an error
};

template <class T>
Error error_of(const Result<T>& result) {
  return result ? Error{.code = ErrorCode::kCancelled} : result.error();
}

std::string repeat(std::string_view text, std::size_t count) {
  std::string all;
  all.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class HostileInput : public ::testing::TestWithParam<Reader> {
 protected:
  [[nodiscard]] static std::string root(const std::string& content) {
    return std::string("<") + GetParam().root + ">\n" + content + "\n</" + GetParam().root + ">\n";
  }
  /// The error, which names the file, and came soon.
  [[nodiscard]] static Error refused(const std::string& text) {
    const double start = processor_seconds();
    const auto error = GetParam().read(text);
    EXPECT_LT(processor_seconds() - start, 20) << "bounded time, whatever the machine";
    EXPECT_NE(error.code, ErrorCode::kCancelled) << "was read";
    EXPECT_EQ(error.file, "hostile.xml");
    return error;
  }
};

TEST_P(HostileInput, EntitiesThatGrowAreRefused) {
  std::string bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [\n <!ENTITY lol0 \"lol\">\n";
  for (int i = 1; i < 10; ++i) {
    bomb += "<!ENTITY lol" + std::to_string(i) + " \"" + repeat("&lol" + std::to_string(i - 1) + ";", 10) + "\">\n";
  }
  const auto error = refused(bomb + "]>\n" + root("<A>&lol9;</A>"));
  EXPECT_EQ(error.code, ErrorCode::kFileLimit);
  EXPECT_EQ(error.line, 2);
  EXPECT_THAT(describe(error), HasSubstr("entities of its own"));
}

TEST_P(HostileInput, EntitiesOfOtherFilesAreRefused) {
  const auto error = refused("<!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>\n" + root("<A>&x;</A>"));
  EXPECT_EQ(error.code, ErrorCode::kFileLimit);
  EXPECT_EQ(refused(root("<!ENTITY x SYSTEM \"file:///etc/passwd\">")).line, 2);
}

TEST_P(HostileInput, DeepNestingIsRefusedWithItsLine) {
  for (const std::size_t depth : {std::size_t{300}, std::size_t{1'000'000}}) {
    const auto error = refused(root(repeat("<A>\n", depth) + repeat("</A>", depth)));
    EXPECT_EQ(error.code, ErrorCode::kFileLimit);
    EXPECT_EQ(error.line, kMaxDepth + 1);
    EXPECT_THAT(describe(error), HasSubstr("nested more than 200 deep"));
  }
}

TEST_P(HostileInput, NestingThatNeverEndsIsRefused) {
  EXPECT_EQ(refused(std::string("<") + GetParam().root + ">" + repeat("<A>", 5'000'000)).code, ErrorCode::kFileLimit);
}

TEST_P(HostileInput, ManyAttributesAreRefused) {
  std::string element = "<A ";
  for (int i = 0; i < 200'000; ++i) element += "a" + std::to_string(i) + "=\"\" ";
  const auto error = refused(root(element + "/>"));
  EXPECT_EQ(error.code, ErrorCode::kFileLimit);
  EXPECT_EQ(error.line, 2);
  EXPECT_THAT(describe(error), HasSubstr("more than 1000 attributes"));
}

TEST_P(HostileInput, ManyElementsAreRefused) {
  const auto error = refused(root(repeat("<A/>", kMaxElements)));
  EXPECT_EQ(error.code, ErrorCode::kFileLimit);
  EXPECT_THAT(describe(error), HasSubstr("more than 4000000 elements"));
}

/// Each takes more than a hundred bytes of memory, whatever it has in the file.
TEST_P(HostileInput, ElementsAttributesAndCommentsWithoutContentAreRefused) {
  for (const char* part : {"<A/>", "<A b=\"\"/>", "<!---->"}) {
    const auto error = refused(root(repeat(part, 120'000)));
    EXPECT_EQ(error.code, ErrorCode::kFileLimit) << part;
    EXPECT_THAT(describe(error), HasSubstr("of less than 10 bytes each, as no tool writes them"));
  }
}

/// Few of each element, and too many of all.
TEST(XmlLimits, AttributesAreCountedOverAllElements) {
  const std::string element = "<B" + repeat(" abcd=\"1234\"", kMaxAttributesOfElement) + "/>";
  constexpr auto kMost = kMaxAttributes / kMaxAttributesOfElement;
  EXPECT_TRUE(check_xml_limits("<A>" + repeat(element, kMost) + "</A>", "x.xml"));
  const auto refused = check_xml_limits("<A>" + repeat(element, kMost + 1) + "</A>", "x.xml");
  ASSERT_FALSE(refused);
  EXPECT_THAT(describe(refused.error()), HasSubstr("more than 4000000 attributes"));
}

TEST(XmlLimits, ManyElementsAsToolsWriteThemPass) {
  const std::string text = "<A>" + repeat("<B>12345</B>", 120'000) + repeat("<C/>", 10'000) + "</A>";
  EXPECT_TRUE(check_xml_limits(text, "x.xml"));
  EXPECT_TRUE(check_xml_limits("<A>" + repeat("<B/>", 90'000) + "</A>", "x.xml")) << "few of them do no harm";
}

TEST_P(HostileInput, ALongAttributeIsReadOrRefusedInTime) {
  const double start = processor_seconds();
  (void)GetParam().read(root("<A B=\"" + std::string(64U << 20, 'x') + "\"/>"));
  EXPECT_LT(processor_seconds() - start, 20);
  EXPECT_EQ(refused(root("<A B=\"" + std::string(kMaxFileBytes, 'x') + "\"/>")).code, ErrorCode::kFileLimit);
}

TEST_P(HostileInput, TagsInCommentsAndValuesDoNotCount) {
  const auto many = repeat("<A>", 1'000);
  for (const auto& content : {"<!--" + many + "-->", "<![CDATA[" + many + "]]>", "<A B=\"" + many + "\"/>",
                              "<A B='" + many + "'/>", "<?pi " + many + "?>"}) {
    EXPECT_NE(GetParam().read(root(content)).code, ErrorCode::kFileLimit) << content.substr(0, 20);
  }
}

TEST_P(HostileInput, WideUtf16IsCheckedAsWell) {
  std::string wide = "\xFF\xFE";
  for (const char c : root(repeat("<A>", 1'000))) wide.append({c, '\0'});
  EXPECT_EQ(refused(wide).code, ErrorCode::kFileLimit);
}

Error read_as_esi(const std::string& text) { return error_of(parse_esi(text, "hostile.xml")); }
Error read_as_eni(const std::string& text) { return error_of(parse_eni(text, "hostile.xml")); }
Error read_as_project(const std::string& text) { return error_of(parse_project(text, "hostile.xml")); }

INSTANTIATE_TEST_SUITE_P(All, HostileInput,
                         ::testing::Values(Reader{"Esi", "EtherCATInfo", read_as_esi},
                                           Reader{"Eni", "EtherCATConfig", read_as_eni},
                                           Reader{"Project", "SynclineProject", read_as_project}),
                         [](const auto& parameter) { return parameter.param.name; });

// ---- files -----------------------------------------------------------------------------------------

class HostileFile : public ::testing::Test {
 protected:
  HostileFile() {
    std::string pattern = (std::filesystem::temp_directory_path() / "syncline-hostile-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~HostileFile() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

TEST_F(HostileFile, AFileOfManyGigabytesIsNotRead) {
  std::ofstream(path("big.xml")) << "<EtherCATInfo>";
  std::filesystem::resize_file(path("big.xml"), std::uintmax_t{40} << 30);  // sparse
  rusage before{}, after{};
  ::getrusage(RUSAGE_SELF, &before);
  for (const auto& error : {error_of(read_esi(path("big.xml"))), error_of(load_project(path("big.xml"))),
                            error_of(read_eni(path("big.xml")))}) {
    EXPECT_EQ(error.code, ErrorCode::kFileLimit);
    EXPECT_EQ(error.file, path("big.xml"));
    EXPECT_THAT(describe(error), HasSubstr("more than 128 MB"));
  }
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 << 10);
}

TEST_F(HostileFile, WhatNeverEndsIsNotReadForEver) {
  EXPECT_EQ(error_of(read_file("/dev/zero")).code, ErrorCode::kFileLimit);
  EXPECT_EQ(error_of(read_file(path(""))).code, ErrorCode::kFileNotReadable);
  EXPECT_EQ(read_file("/dev/null").value(), "");
}

// ---- names -----------------------------------------------------------------------------------------

/// Any characters that XML can carry, of every plane.
std::string unicode_name() {
  const auto code =
      rc::gen::oneOf(rc::gen::inRange<std::uint32_t>(0x20, 0x7F), rc::gen::inRange<std::uint32_t>(0xA0, 0x800),
                     rc::gen::inRange<std::uint32_t>(0x800, 0xD800), rc::gen::inRange<std::uint32_t>(0xE000, 0xFFFE),
                     rc::gen::inRange<std::uint32_t>(0x10000, 0x110000));
  std::string name = "n";  // blanks at the ends are no part of a name
  for (const auto c : *rc::gen::container<std::vector<std::uint32_t>>(code)) {
    const auto add = [&name](std::uint32_t byte) { name += static_cast<char>(byte); };
    if (c < 0x80) {
      add(c);
      continue;
    }
    if (c < 0x800) {
      add(0xC0 | c >> 6);
    } else if (c < 0x10000) {
      add(0xE0 | c >> 12);
      add(0x80 | (c >> 6 & 0x3F));
    } else {
      add(0xF0 | c >> 18);
      add(0x80 | (c >> 12 & 0x3F));
      add(0x80 | (c >> 6 & 0x3F));
    }
    add(0x80 | (c & 0x3F));
  }
  return name + ".";
}

TEST(Names, AnyUnicodeComesBackFromProjectAndEni) {
  EXPECT_TRUE(rc::check([] {
    auto project = sample::small_machine();
    project.name = unicode_name();
    for (auto& slave : project.slaves) slave.name = unicode_name();
    const auto read = parse_project(write_project(project), "p");
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->name == project.name);
    const auto compiled = compile(project);
    RC_ASSERT(compiled.has_value());
    const auto eni = parse_eni(write_eni(compiled->config), "e");
    RC_ASSERT(eni.has_value());
    for (std::size_t i = 0; i < project.slaves.size(); ++i) {
      RC_ASSERT(read->slaves[i].name == project.slaves[i].name);
      RC_ASSERT(eni->slaves[i].name == compiled->config.slaves[i].name);
      RC_ASSERT(eni->slaves[i].name == project.slaves[i].name);
    }
  }));
}

TEST(Names, BytesThatAreNoCharactersDoNotSpoilTheOthers) {
  auto project = sample::small_machine();
  project.slaves[0].name = "broken \xFF\xC3 name";
  project.slaves[1].name = "Łódź \U0001F600";
  const auto text = write_project(project);
  EXPECT_TRUE(is_utf8(text));
  const auto read = parse_project(text, "p");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->slaves[1].name, project.slaves[1].name);
  EXPECT_EQ(read->slaves[0].name, "broken \xC3\xBF\xC3\x83 name");  // as ISO-8859-1
}

TEST(Names, WhatXmlCannotCarryIsLeftOut) {
  XmlWriter xml;
  xml.open("A")
      .attribute("B",
                 "a\x01\x02"
                 "b\xEF\xBF\xBE\xEF\xBF\xBF"
                 "c")
      .close();
  EXPECT_THAT(xml.take(), HasSubstr("B=\"abc\""));
}

}  // namespace
}  // namespace syncline::eni
