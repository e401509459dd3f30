// SPDX-License-Identifier: Apache-2.0
#include "check/validate.h"

#include <gtest/gtest.h>

#include <vector>

namespace syncline {
namespace {

struct ValidateCase {
  ValidateType type;
  bool is_signed;
  std::vector<std::uint8_t> expected, mask, read;
  bool satisfied;
};

class Validate : public testing::TestWithParam<ValidateCase> {};

TEST_P(Validate, ComparesAsTheTypeSays) {
  const auto& [type, is_signed, expected, mask, read, satisfied] = GetParam();
  EXPECT_EQ(satisfies({expected, mask, 0, type, is_signed}, read), satisfied);
}

INSTANTIATE_TEST_SUITE_P(
    Types, Validate,
    testing::Values(ValidateCase{ValidateType::kEqual, false, {0x02, 0x00}, {0x0F, 0x00}, {0xF2, 0x55}, true},
                    ValidateCase{ValidateType::kEqual, false, {0x02, 0x00}, {}, {0xF2, 0x00}, false},
                    ValidateCase{ValidateType::kEqual, false, {0x02, 0x01}, {}, {0x02}, false},  // what is missing is 0
                    ValidateCase{ValidateType::kNotEqual, false, {0x02}, {}, {0x03}, true},
                    ValidateCase{ValidateType::kNotEqual, false, {0x02}, {}, {0x02}, false},
                    ValidateCase{
                        ValidateType::kGreaterOrEqual, false, {0xFF, 0x01}, {}, {0x00, 0x02}, true},  // little endian
                    ValidateCase{ValidateType::kGreaterOrEqual, false, {0x00, 0x02}, {}, {0x00, 0x02}, true},
                    ValidateCase{ValidateType::kGreaterOrEqual, false, {0x00, 0x02}, {}, {0xFF, 0x01}, false},
                    ValidateCase{ValidateType::kGreater, false, {0x05}, {}, {0x05}, false},
                    ValidateCase{ValidateType::kGreater, false, {0x05}, {}, {0xFF}, true},
                    ValidateCase{ValidateType::kGreater, true, {0x05}, {}, {0xFF}, false},  // -1
                    ValidateCase{ValidateType::kLess, true, {0x00, 0x00}, {}, {0x00, 0x80}, true},
                    ValidateCase{ValidateType::kLess, false, {0x00, 0x00}, {}, {0x00, 0x80}, false},
                    ValidateCase{ValidateType::kLessOrEqual, true, {0xFE, 0xFF}, {}, {0xFE, 0xFF}, true},
                    ValidateCase{ValidateType::kLessOrEqual, true, {0xFE, 0xFF}, {}, {0xFF, 0xFF}, false},
                    ValidateCase{ValidateType::kNone, false, {0x01}, {}, {0x02}, true}));

}  // namespace
}  // namespace syncline
