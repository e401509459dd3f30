// SPDX-License-Identifier: Apache-2.0
#include "ui/text/error_text.h"

#include "findings/error_text.h"
#include "ui/text/finding_text.h"

namespace syncline::ui {

QString errorText(const Error& error) { return findingWhole(finding_of(error)); }

}  // namespace syncline::ui
