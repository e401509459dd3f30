// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/result.h"

/// The words of errors: rows of the one table, which fields of an Error fill.
namespace syncline {

struct Finding;

/// The error as a finding, with the figures that its row shows. Each ErrorCode has a row, whose code is for programs:
/// "file-not-found", "state-refused". Placeholders:
///   {subject} {detail} {file} {expected} {received}  the fields as they are
///   {where}    "file:line", "file" when there is no line
///   {because}  ": detail", nothing when there is no detail
///   {state}    AL state of `expected`               {actual}  AL status `received`
///   {alcode}   `extra` as AL status code            {check}   what to look at then
///   {code}     `received` as SDO abort or FoE error code, {meaning} its meaning
///   {error}    `received` in ns                     {limit}   `expected` in ns
[[nodiscard]] Finding finding_of(const Error& error);

/// The same with its place, as it stands in another reason's placeholder: "{device} is left out: {error}".
[[nodiscard]] Reason reason_of(const Error& error);

/// English sentences: where, what happened, and what to do.
[[nodiscard]] std::string describe(const Error& error);

}  // namespace syncline
