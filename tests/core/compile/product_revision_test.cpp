// SPDX-License-Identifier: Apache-2.0
#include "compile/product_revision.h"

#include <gtest/gtest.h>

#include "compile/compile.h"
#include "tests/support/sample_devices.h"

namespace syncline::compiler {
namespace {

DeviceDescription device(std::uint32_t vendor, std::string type, std::uint32_t revision) {
  DeviceDescription out;
  out.identity = {vendor, 1, revision, 0};
  out.type = std::move(type);
  return out;
}

TEST(ProductRevision, IsTypeAndBothWordsOfTheRevision) {
  EXPECT_EQ(product_revision(device(2, "EK1100", 0x0012'0000)), "EK1100-0000-0018");
  EXPECT_EQ(product_revision(device(2, "EL7211-0010", 0x0013'000A)), "EL7211-0010-0019");
  EXPECT_EQ(product_revision(device(0x9A, "Gold", 0x0001'0420)), "");
}

TEST(ProductRevision, IsWrittenInTheTwinCatDialectOnly) {
  Project project = sample::project({sample::digital_input()});
  project.slaves[0].device.identity = {2, 0x03EA3052, 0x0011'0000, 0};
  project.slaves[0].device.type = "EL1002";
  EXPECT_EQ(compile(project, {EniDialect::kTwinCat}).value().config.slaves[0].product_revision, "EL1002-0000-0017");
  EXPECT_EQ(compile(project, {EniDialect::kEcEngineer}).value().config.slaves[0].product_revision, "");
}

}  // namespace
}  // namespace syncline::compiler
