// SPDX-License-Identifier: Apache-2.0
#include "master/sync_error_integrator.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(SyncErrorIntegrator, AddsThreeForAMissAndTakesOneForAGoodCycle) {
  SyncErrorIntegrator integrator;
  integrator.read(7, 1000);
  EXPECT_EQ(integrator.value(), 0U) << "what was before is over";
  integrator.read(9, 1020);
  EXPECT_EQ(integrator.value(), 6U);
  integrator.read(9, 1024);
  EXPECT_EQ(integrator.value(), 2U);
  integrator.read(9, 1100);
  EXPECT_EQ(integrator.value(), 0U) << "never below";
  integrator.read(10, 1101);
  integrator.read(11, 1102);
  EXPECT_EQ(integrator.value(), 6U);
}

TEST(SyncErrorIntegrator, ACounterThatBeginsAnewBringsAnIntegratorThatDoes) {
  SyncErrorIntegrator integrator;
  integrator.read(0, 0);
  integrator.read(4, 10);
  EXPECT_EQ(integrator.value(), 12U);
  integrator.read(0, 12);
  EXPECT_EQ(integrator.value(), 0U);
  integrator.read(2, 14);
  EXPECT_EQ(integrator.value(), 6U);
  integrator.reset();
  integrator.read(100, 20);
  EXPECT_EQ(integrator.value(), 0U);
}

TEST(SyncErrorIntegrator, AnyCounterIsBounded) {
  SyncErrorIntegrator integrator;
  integrator.read(0, 5);
  integrator.read(0xFFFF'FFFF, 1);  // cycles that run backwards are none
  EXPECT_EQ(integrator.value(), 0xFFFFU);
}

}  // namespace
}  // namespace syncline
