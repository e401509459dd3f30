// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QTemporaryDir>

namespace syncline::test {

/// The catalogue's database is the test's own.
class OwnCache {
 public:
  OwnCache() : before_(qgetenv("XDG_CACHE_HOME")) { qputenv("XDG_CACHE_HOME", folder_.path().toUtf8()); }
  ~OwnCache() { qputenv("XDG_CACHE_HOME", before_); }

 private:
  QTemporaryDir folder_;
  QByteArray before_;
};

}  // namespace syncline::test
