// SPDX-License-Identifier: MIT
#pragma once

// A reader of corpus/shapes.txt: outlines of lines and curves, as sources of one glyph each.

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/outline/recorded_outlines.hpp>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

struct named_shape {
    std::string name;
    typemesh::recorded_outlines font;  ///< its glyph 0
};

/// The shapes of a file in tests/corpus. Throws if it cannot be read or breaks the format.
inline std::vector<named_shape> shapes_of(const char* file)
{
    using namespace typemesh;
    std::ifstream in{std::string{TYPEMESH_TEST_DATA "/corpus/"} + file};
    if (!in) throw std::runtime_error(std::string{"tests/corpus/"} + file + " cannot be read");
    struct call {
        char verb;
        std::vector<double> at;
    };
    std::vector<named_shape> all;
    std::vector<call> calls;
    std::string name, rule, line;
    double units = 0.0;
    const auto finish = [&] {
        recorded_outlines drawn{units, rule == "evenodd" ? fill_rule::even_odd : fill_rule::non_zero};
        const auto id = drawn.add([&](auto& pen) {
            for (const auto& [verb, p] : calls) {
                if (verb == 'M') pen.move({p.at(0), p.at(1)});
                if (verb == 'L') pen.line({p.at(0), p.at(1)});
                if (verb == 'Q') pen.quadratic({p.at(0), p.at(1)}, {p.at(2), p.at(3)});
                if (verb == 'C') pen.cubic({p.at(0), p.at(1)}, {p.at(2), p.at(3)}, {p.at(4), p.at(5)});
                if (verb == 'Z') pen.close();
            }
        });
        if (!id) throw std::runtime_error(name + ": " + id.error().message());
        all.push_back({name, std::move(drawn)});
        calls.clear();
    };
    while (std::getline(in, line)) {
        std::istringstream words{line};
        std::string verb;
        if (!(words >> verb) || verb[0] == '#') continue;
        if (verb == "shape") {
            if (!(words >> name >> rule >> units)) throw std::runtime_error("a broken shape: " + line);
        } else if (verb == "end") {
            finish();
        } else {
            call c{verb[0], {}};
            for (double v = 0.0; words >> v;) c.at.push_back(v);
            calls.push_back(std::move(c));
        }
    }
    return all;
}

}  // namespace test
