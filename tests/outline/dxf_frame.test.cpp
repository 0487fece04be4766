// SPDX-License-Identifier: MIT
#include <typemesh/outline/dxf_writer.hpp>
#include <typemesh/outline/impl/dxf_frame.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a drawing has all sections and tables of its version, and no handle twice", "[outline][dxf]")
{
    dxf_writer drawing;
    drawing.move({0.0, 0.0});
    drawing.line({1.0, 0.0});
    drawing.quadratic({2.0, 1.0}, {1.0, 2.0});
    drawing.close();
    REQUIRE(drawing.finish());
    REQUIRE(drawing.text().starts_with(detail::dxf_begin));
    REQUIRE(drawing.text().ends_with(detail::dxf_end));
    std::istringstream in{std::string{drawing.text()}};
    std::vector<std::pair<int, std::string>> all;
    for (std::string code, value; std::getline(in, code);) {
        REQUIRE(std::getline(in, value));
        REQUIRE(code.find_first_not_of("0123456789") == std::string::npos);
        all.push_back({std::stoi(code), value});
    }
    std::vector<std::string> tables, sections, handles, referred;
    std::size_t entities = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& [code, value] = all[i];
        if (code == 0 && value == "SECTION") sections.push_back(all[i + 1].second);
        if (code == 0 && value == "TABLE") tables.push_back(all[i + 1].second);
        if (code == 0 && (value == "LINE" || value == "SPLINE")) ++entities;
        if (sections.size() == 1) continue;  // the header has a seed, no handle
        if (code == 5 || code == 105) handles.push_back(value);
        if ((code == 330 || code == 340 || code == 350 || code == 390) && value != "0") referred.push_back(value);
    }
    CHECK(sections == std::vector<std::string>{"HEADER", "CLASSES", "TABLES", "BLOCKS", "ENTITIES", "OBJECTS"});
    std::sort(tables.begin(), tables.end());
    CHECK(tables == std::vector<std::string>{"APPID", "BLOCK_RECORD", "DIMSTYLE", "LAYER", "LTYPE", "STYLE", "UCS",
                                             "VIEW", "VPORT"});
    std::sort(handles.begin(), handles.end());
    CHECK(std::adjacent_find(handles.begin(), handles.end()) == handles.end());
    for (const std::string& handle : referred) {
        INFO(handle);
        CHECK(std::binary_search(handles.begin(), handles.end(), handle));
    }
    CHECK(static_cast<std::size_t>(std::count(referred.begin(), referred.end(), detail::dxf_model_space)) ==
          entities + 3);  // its two block entities and its layout
}
