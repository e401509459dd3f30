// SPDX-License-Identifier: Apache-2.0
#include "config/image_owners.h"

#include <gtest/gtest.h>

#include "config/network_config.h"
#include "config/process_image.h"

namespace syncline {
namespace {

TEST(ImageOwners, KnowEachSlavesPart) {
  NetworkConfig config;
  config.slaves.resize(3);
  config.slaves[0].send = ImageRange{16, 8};
  config.slaves[1].send = ImageRange{0, 3};
  config.slaves[2].receive = ImageRange{0, 64};
  config.slaves[2].receive_parts = {{0, 16}, {48, 16}};
  const ImageOwners owners(config);
  EXPECT_EQ(owners.of_output(0), 1U);
  EXPECT_EQ(owners.of_output(2), 1U);
  EXPECT_EQ(owners.of_output(3), std::nullopt) << "padding";
  EXPECT_EQ(owners.of_output(16), 0U);
  EXPECT_EQ(owners.of_output(23), 0U);
  EXPECT_EQ(owners.of_output(24), std::nullopt);
  EXPECT_EQ(owners.of_input(15), 2U);
  EXPECT_EQ(owners.of_input(20), std::nullopt) << "between its pieces";
  EXPECT_EQ(owners.of_input(48), 2U);
  EXPECT_EQ(ImageOwners(NetworkConfig{}).of_input(0), std::nullopt);
}

}  // namespace
}  // namespace syncline
