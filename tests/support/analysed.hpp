// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"

#include <typemesh/unicode/unicode_analyser.hpp>

namespace test {

inline typemesh::text_analysis analysed(typemesh::text_view text, const typemesh::analysis_options& how = {})
{
    typemesh::text_analysis found;
    REQUIRE_FALSE(typemesh::unicode_analyser{}.analyse(text, how, found));
    return found;
}

}  // namespace test
