// SPDX-License-Identifier: MIT
#pragma once
#define HB_VERSION_STRING "2.7.4"
