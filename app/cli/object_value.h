// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "protocol/object_value.h"

/// Values of objects as the command line writes them.
namespace syncline::cli {

using syncline::data_type_code;
using syncline::data_type_name;
using syncline::kBytesType;
using syncline::kStringType;
using syncline::object_name;
using syncline::ObjectName;
using syncline::value_bytes;
using syncline::value_text;

}  // namespace syncline::cli
