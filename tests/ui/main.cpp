// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QApplication>
#include <QByteArray>
#include <QLocale>
#include <QLoggingCategory>
#include <cstdio>

#include "ui/theme/theme.h"

namespace {

/// A warning of Qt is a fault of ours: a bad connection, a model that breaks its contract, a missing icon.
void onQtMessage(QtMsgType type, const QMessageLogContext&, const QString& text) {
  std::fprintf(stderr, "Qt: %s\n", qPrintable(text));
  // The offscreen platform says this for every window; it cannot do otherwise.
  if (text.contains(QLatin1String("propagateSizeHints"))) return;
  // Nor can it do more for a menu or a tool tip that comes up.
  if (text.contains(QLatin1String("does not support raise")) || text.contains(QLatin1String("grabbing the keyboard")))
    return;
  // A test's folder may go before the window that has a file of it open.
  if (text.contains(QLatin1String("remove our own lock file"))) return;
  if (type != QtDebugMsg && type != QtInfoMsg) ADD_FAILURE() << "Qt said: " << qPrintable(text);
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  ::testing::InitGoogleTest(&argc, argv);
  // What a test starts as a program of its own is a disabled one, and in whatever part of the tests that test is.
  if (::testing::GTEST_FLAG(also_run_disabled_tests)) {
    qunsetenv("GTEST_TOTAL_SHARDS");
    qunsetenv("GTEST_SHARD_INDEX");
  }
  QApplication app(argc, argv);
  QLocale::setDefault(QLocale::c());
  syncline::ui::theme::apply(syncline::ui::theme::Mode::kLight);
  qInstallMessageHandler(&onQtMessage);
  const int result = RUN_ALL_TESTS();
  qInstallMessageHandler(nullptr);
  return result;
}
