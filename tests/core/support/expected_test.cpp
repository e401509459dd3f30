// SPDX-License-Identifier: Apache-2.0
#include "support/expected.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

#include "support/result.h"

namespace syncline::test {
namespace {

/// An error for whose copy there is no memory.
struct Scarce {
  explicit Scarce(std::string own_words) : words(std::move(own_words)) {}
  Scarce(const Scarce&) { throw std::bad_alloc(); }
  Scarce(Scarce&&) = default;
  Scarce& operator=(const Scarce&) { throw std::bad_alloc(); }
  Scarce& operator=(Scarce&&) = default;
  ~Scarce() = default;
  std::string words;
};

template <class T>
Expected<T, Scarce> refused() {
  return tl::unexpected(Scarce("no"));
}

TEST(Expected, ACopyOfAnErrorWithoutMemoryForItThrows) {
  const auto nothing = refused<void>();
  const auto number = refused<int>();
  EXPECT_THROW((Expected<void, Scarce>(nothing)), std::bad_alloc);
  EXPECT_THROW((Expected<int, Scarce>(number)), std::bad_alloc);
}

TEST(Expected, AnAssignmentOfAnErrorWithoutMemoryForItThrowsAndChangesNothing) {
  const auto number = refused<int>();
  Expected<int, Scarce> right = 3, wrong = tl::unexpected(Scarce("other"));
  EXPECT_THROW(right = number, std::bad_alloc);
  EXPECT_THROW(wrong = number, std::bad_alloc);
  ASSERT_TRUE(right);
  EXPECT_EQ(*right, 3);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().words, "other");
}

TEST(Expected, WhatIsCopiedIsEqual) {
  const Result<std::string> value = "a word that is longer than what a string holds in itself";
  const Result<std::string> error = fail(ErrorCode::kFileNotFound, "subject");
  const Status done, failed = fail(ErrorCode::kFileNotFound, "subject");
  const std::vector<Result<std::string>> copies{value, error, value};
  EXPECT_EQ(copies[0], value);
  EXPECT_EQ(copies[1], error);
  EXPECT_NE(copies[1], copies[2]);
  EXPECT_EQ(Status(failed), failed);
  EXPECT_EQ(Status(done), done);
  EXPECT_NE(failed, done);
}

/// A vector that grows moves them.
TEST(Expected, IsMovedWithoutACopy) {
  std::vector<Expected<void, Scarce>> several;
  for (int i = 0; i < 9; ++i) several.push_back(refused<void>());
  EXPECT_EQ(several.front().error().words, "no");
  static_assert(std::is_nothrow_move_constructible_v<Status> && std::is_nothrow_move_assignable_v<Status>);
}

TEST(Expected, OfABoolIsCopiedNotAskedWhetherItHoldsOne) {
  Result<bool> no = false;
  const Result<bool> same(no);
  const Result<bool> braced{no};
  EXPECT_THAT(same, testing::Optional(false));
  EXPECT_THAT(braced, testing::Optional(false));
}

TEST(Expected, OfAPointerBecomesOneOfItsBase) {
  struct Base {
    virtual ~Base() = default;
  };
  struct Derived : Base {};
  Result<std::unique_ptr<Derived>> derived = std::make_unique<Derived>();
  const auto* where = derived->get();
  const Result<std::unique_ptr<Base>> base = std::move(derived);
  ASSERT_TRUE(base);
  EXPECT_EQ(base->get(), where);
  static_assert(!std::copy_constructible<Result<std::unique_ptr<Base>>>);
}

TEST(Expected, TheNextStepIsTakenWhereThePreviousOneSucceeded) {
  int steps = 0;
  const auto step = [&](bool succeeds) -> Status {
    ++steps;
    return succeeds ? Status{} : fail(ErrorCode::kTimeout);
  };
  EXPECT_TRUE(step(true).and_then([&] { return step(true); }));
  EXPECT_EQ(steps, 2);
  EXPECT_EQ(step(false).and_then([&] { return step(true); }), Status(fail(ErrorCode::kTimeout)));
  EXPECT_EQ(steps, 3);
}

}  // namespace
}  // namespace syncline::test
