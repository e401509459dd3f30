// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/editors/record_part.h"

namespace syncline::ui {

class Page;

/// The items of a key with a number for each, like "slave.N.startup.K" or "master.register.K", of the node that `page`
/// shows. They are ordered; `fresh` is what Add appends.
[[nodiscard]] RecordList itemList(const Page& page, const char* key, const QString& item, const QString& nothing,
                                  const char* fresh);

}  // namespace syncline::ui
