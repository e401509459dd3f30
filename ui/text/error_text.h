// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>

#include "support/result.h"

namespace syncline::ui {

/// The sentence of an error in the user's language: what happened, where, and what to do.
[[nodiscard]] QString errorText(const Error& error);

/// The sentence templates that translations know.
[[nodiscard]] std::span<const char* const> translatableErrors();

}  // namespace syncline::ui
