// SPDX-License-Identifier: MIT

// Must not compile: an observer that takes anything could be a discretiser as well, and so could a policy of two trades.

#include "../support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

struct two_trades {
    error operator()(const region&, workspace&, triangle_list&) const noexcept { return {}; }
    void operator()(stage) const noexcept {}
};

void exchange(test::toy_font& font)
{
    auto watched = text_mesher{font}.with([](auto&&...) noexcept {});
    auto cut = text_mesher{font}.with(two_trades{});
}
