// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/layout_options.hpp>

#include <limits>
#include <string>

using namespace typemesh;

TEST_CASE("options of a paragraph that are out of range are named", "[paragraph]")
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    CHECK_FALSE(refused_option(layout_options{}));
    const double falling[] = {2.0, 1.0}, at_zero[] = {0.0}, unknown[] = {nan}, rising[] = {0.5, 1.0};
    CHECK_FALSE(refused_option({.width = 1e-9, .indent = -3.0, .tab_width = 0.0, .tab_stops = rising}));
    struct expected {
        layout_options options;
        const char* name;
    };
    for (const auto& [options, name] : {expected{{.width = 0.0}, "width"},
                                        {{.width = -1.0}, "width"},
                                        {{.width = nan}, "width"},
                                        {{.height = -1.0}, "height"},
                                        {{.height = inf}, "height"},
                                        {{.max_lines = 0}, "max_lines"},
                                        {{.line_spacing = nan}, "line_spacing"},
                                        {{.indent = inf}, "indent"},
                                        {{.tab_width = -1.0}, "tab_width"},
                                        {{.tab_width = inf}, "tab_width"},
                                        {{.tab_stops = falling}, "tab_stops"},
                                        {{.tab_stops = at_zero}, "tab_stops"},
                                        {{.tab_stops = unknown}, "tab_stops"}}) {
        const error e = refused_option(options);
        CHECK(e == error::bad_option);
        REQUIRE(e.option != nullptr);
        CHECK(std::string{e.option} == name);
    }
}
