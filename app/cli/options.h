// SPDX-License-Identifier: Apache-2.0
#pragma once

// What files need that add options to a command; thousands of inline lines, so no other header includes it.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
