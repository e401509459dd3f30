// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "protocol/diagnosis_message.h"

namespace syncline {

/// A parameter of a diagnosis message as a value: numbers by the basic type that its flags name, text as text, else
/// bytes ("12 ab").
[[nodiscard]] std::string parameter_text(const DiagnosisMessage::Parameter& parameter);

/// MessageText of the ESI's DiagMessages with the message's parameters at its C conversions, in their order (%d %i %u
/// %x %X %o %c %s %f %e %g, with flags, width, precision and length; %% stands for itself). A conversion that has no
/// parameter, or one that it does not fit, shows what there is: "?" or the parameter as a value; parameters that the
/// text has no place for follow in brackets. Nothing in `text` is trusted.
[[nodiscard]] std::string diagnosis_text(std::string_view text, const DiagnosisMessage& message);

/// Without a text: "text 0x001A [5] [12 ab]".
[[nodiscard]] std::string raw_diagnosis_text(const DiagnosisMessage& message);

}  // namespace syncline
