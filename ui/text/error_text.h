// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "support/result.h"

namespace syncline::ui {

/// The sentences of an error in the user's language: what happened, where, and what to do.
[[nodiscard]] QString errorText(const Error& error);

}  // namespace syncline::ui
