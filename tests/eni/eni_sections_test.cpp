// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_sections.h"

#include <gtest/gtest.h>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

TEST(EniSections, AreFoundInBothDialects) {
  const auto project = sample::small_machine();
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    const auto compiled = compile(project, {dialect});
    ASSERT_TRUE(compiled);
    const auto text = write_eni(compiled->config, style_of(dialect));
    const auto lines = lines_of(text);
    const auto sections = sections_of(lines);
    ASSERT_EQ(sections.size(), 1 + project.slaves.size() + 2);
    EXPECT_EQ(sections.front().part, EniPart::kMaster);
    EXPECT_EQ(sections[sections.size() - 2].part, EniPart::kCyclic);
    EXPECT_EQ(sections.back().part, EniPart::kProcessImage);
    std::size_t next = sections.front().first;
    for (const auto& section : sections) {
      EXPECT_EQ(section.first, next) << "one behind the other";
      next = section.first + section.count;
    }
    EXPECT_EQ(next, lines.size() - 2) << "then Config and the root are closed";
    for (std::size_t slave = 0; slave < project.slaves.size(); ++slave) {
      EXPECT_EQ(sections[1 + slave].slave, static_cast<int>(slave));
      const auto name = "<Name>" + project.slaves[slave].name + "</Name>";
      bool named = false;
      for (std::size_t i = 0; i < sections[1 + slave].count; ++i)
        named = named || lines[sections[1 + slave].first + i].find(name) != std::string_view::npos;
      EXPECT_TRUE(named) << name;
    }
  }
}

TEST(EniSections, OfOtherTextAreNone) {
  EXPECT_TRUE(sections_of(lines_of("")).empty());
  EXPECT_TRUE(sections_of(lines_of("<a>\n<b/>\n</a>\n")).empty());
  EXPECT_TRUE(sections_of(lines_of("<Config>\n")).empty());
  EXPECT_EQ(lines_of("a\n\nb").size(), 3U);
  EXPECT_EQ(lines_of("a\n").size(), 1U);
}

}  // namespace
}  // namespace syncline::eni
