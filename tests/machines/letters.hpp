// SPDX-License-Identifier: MIT
#pragma once

// Reads letters.txt.

#include <typemesh/outline/recorded_outlines.hpp>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace machines {

struct face {
    std::string name;
    typemesh::recorded_outlines letters;

    face(std::string called, double units_per_em) : name{std::move(called)}, letters{units_per_em} {}
};

[[noreturn]] inline void stop(const std::string& words)
{
    std::fprintf(stderr, "%s\n", words.c_str());
    std::exit(2);
}

/// The contours of one letter, a line each.
inline void draw(const std::vector<std::string>& contours, typemesh::outline_sink auto& pen)
{
    for (const std::string& contour : contours) {
        std::istringstream in{contour};
        const auto next = [&in] {
            typemesh::point p;
            in >> p.x >> p.y;
            return p;
        };
        for (char step = 0; in >> step;) {
            switch (step) {
            case 'M': pen.move(next()); break;
            case 'L': pen.line(next()); break;
            case 'Q': {
                const typemesh::point control = next();
                pen.quadratic(control, next());
                break;
            }
            case 'C': {
                const typemesh::point first = next(), second = next();
                pen.cubic(first, second, next());
                break;
            }
            case 'Z': pen.close(); break;
            default: stop("letters.txt: there is no step " + std::string(1, step));
            }
        }
    }
}

/// Faces are not moved: their letters are referred to.
inline std::vector<std::unique_ptr<face>> read_letters(const std::string& path)
{
    std::ifstream file{path};
    if (!file) stop(path + " cannot be read");
    std::vector<std::unique_ptr<face>> faces;
    std::vector<std::string> contours;
    const auto end_letter = [&] {
        if (contours.empty()) return;
        if (!faces.back()->letters.add([&](auto& pen) { draw(contours, pen); }))
            stop("a letter is refused: " + contours[0]);
        contours.clear();
    };
    for (std::string line; std::getline(file, line);) {
        std::istringstream words{line};
        std::string first, name;
        words >> first;
        if (first == "font") {
            end_letter();
            double units_per_em = 0.0;
            words >> units_per_em >> std::ws;
            std::getline(words, name);
            faces.push_back(std::make_unique<face>(name, units_per_em));
        } else if (first == "letter") {
            end_letter();
        } else if (first == "M") {
            contours.push_back(line);
        }
    }
    end_letter();
    if (faces.empty()) stop(path + " has no letters");
    return faces;
}

}  // namespace machines
