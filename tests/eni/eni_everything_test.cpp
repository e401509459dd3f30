// SPDX-License-Identifier: Apache-2.0
// Every element and attribute of the schema: written, read back, and valid.
#include <gtest/gtest.h>

#include "eni/everything.h"
#include "eni/format/eni_file.h"
#include "eni/format/eni_style.h"
#include "eni/schema_check.h"
#include "findings/error_text.h"

namespace syncline::eni {
namespace {

TEST(EniEverything, IsReadAsItWasWritten) {
  const auto config = everything();
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    const auto again = parse_eni(write_eni(config, style_of(dialect)), "everything.xml");
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(again->master, config.master);
    ASSERT_EQ(again->slaves.size(), config.slaves.size());
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      EXPECT_EQ(again->slaves[i].mailbox, config.slaves[i].mailbox) << i;
      EXPECT_EQ(again->slaves[i].pdos, config.slaves[i].pdos) << i;
      EXPECT_EQ(again->slaves[i].sync_managers, config.slaves[i].sync_managers) << i;
      EXPECT_EQ(again->slaves[i], config.slaves[i]) << i;
    }
    EXPECT_EQ(again->cyclic, config.cyclic);
    EXPECT_EQ(again->image, config.image);
    EXPECT_EQ(write_eni(*again, style_of(dialect)), write_eni(config, style_of(dialect)));
  }
}

class EverythingAgainst : public testing::TestWithParam<Schema> {};
INSTANTIATE_TEST_SUITE_P(Schemas, EverythingAgainst, testing::ValuesIn(eni_schemas()), SchemaName());

TEST_P(EverythingAgainst, TheSchemaIsValid) {
  if (!have_xmllint()) GTEST_SKIP() << "xmllint is not installed";
  for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
    expect_valid(write_eni(everything(), style_of(dialect)), GetParam().path);
  }
}

TEST(EniStyle, SpellsBooleansAsTheDialectsToolDoes) {
  const auto config = everything();
  const std::string theirs = write_eni(config, style_of(EniDialect::kTwinCat));
  const std::string ours = write_eni(config, style_of(EniDialect::kEcEngineer));
  EXPECT_NE(theirs.find("<BeforeSlave>true</BeforeSlave>"), std::string::npos);
  EXPECT_NE(theirs.find("\t<Config>"), std::string::npos);
  EXPECT_EQ(theirs.find(">1</Enable>"), std::string::npos);
  EXPECT_NE(ours.find("<BeforeSlave>1</BeforeSlave>"), std::string::npos);
  EXPECT_EQ(ours.find("true"), std::string::npos);
  EXPECT_EQ(theirs.substr(0, theirs.find('\n')), R"(<?xml version="1.0"?>)");
}

}  // namespace
}  // namespace syncline::eni
