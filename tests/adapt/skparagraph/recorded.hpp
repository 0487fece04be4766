// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What SkParagraph made of some texts: recorded.txt, which record.mjs describes. Pixels at 64 an em, bytes of UTF-8.
namespace skparagraph {

struct font {
    std::string name, path;
    std::size_t bytes = 0;
    std::uint64_t checksum = 0;
};

struct glyph {
    std::string font;
    std::uint32_t id = 0, at = 0;  ///< at: the first byte of its cluster
    double x = 0.0;                ///< from the line's left
};

struct line {
    std::uint32_t first = 0, last = 0;
    double left = 0.0;
    std::vector<glyph> glyphs;  ///< from left to right, without white space at the line's end
};

/// Of a range of the text, on one line.
struct box {
    std::uint32_t first = 0, last = 0;
    std::size_t line = 0;
    double left = 0.0, right = 0.0;
};

struct grapheme {
    std::uint32_t first = 0, last = 0;
    double left = 0.0, right = 0.0;
    bool to_the_left = false;
};

struct hit {
    double x = 0.0;
    std::size_t line = 0;
    std::uint32_t at = 0;
    bool upstream = false;
};

struct layout {
    double width = 0.0;  ///< in em
    std::string align;
    std::vector<line> lines;
    std::vector<box> boxes;
    std::vector<grapheme> graphemes;
    std::vector<hit> hits;
};

struct text {
    std::string name, words;
    bool right_to_left = false;
    std::vector<std::string> fonts;
    std::vector<layout> layouts;
};

struct record {
    std::vector<font> fonts;
    std::vector<text> texts;
};

/// Reads "12.5~40" or "7@3+9.25": the numbers between the marks.
inline double number(std::string_view& s)
{
    const std::string copy{s};
    char* end = nullptr;
    const double value = std::strtod(copy.c_str(), &end);
    s.remove_prefix(static_cast<std::size_t>(end - copy.c_str()));
    if (!s.empty()) s.remove_prefix(1);
    return value;
}

inline std::uint32_t whole(std::string_view& s) { return static_cast<std::uint32_t>(number(s)); }

class reader {
public:
    explicit reader(const std::string& path) : in_{path}
    {
        if (!in_) FAIL("The recorded lines of SkParagraph are missing: " << path);
    }

    record read()
    {
        for (std::string row; std::getline(in_, row);) {
            std::istringstream words{row};
            std::string kind;
            words >> kind;
            if (kind == "font" || kind == "text")
                begin(kind, words);
            else if (kind == "layout")
                begin_layout(words);
            else if (kind == "line" || kind == "run" || kind == "spread")
                add_line(kind, words);
            else
                add_place(kind, words);
        }
        return std::move(all_);
    }

private:
    void begin(const std::string& kind, std::istringstream& words)
    {
        if (kind == "font") {
            font f;
            words >> f.name >> f.path >> f.bytes >> std::hex >> f.checksum;
            all_.fonts.push_back(std::move(f));
            return;
        }
        text t;
        std::string direction;
        words >> t.name >> direction;
        t.right_to_left = direction == "rtl";
        for (std::string name; words >> name;) t.fonts.push_back(name);
        std::getline(in_, t.words);
        if (const auto at = t.words.find("\\n"); at != std::string::npos) t.words.replace(at, 2, "\n");
        all_.texts.push_back(std::move(t));
    }

    void begin_layout(std::istringstream& words)
    {
        layout l;
        words >> l.width >> l.align;
        if (l.align == "left") left_ = all_.texts.back().layouts.size();
        all_.texts.back().layouts.push_back(std::move(l));
    }

    void add_line(const std::string& kind, std::istringstream& words)
    {
        auto& layouts = all_.texts.back().layouts;
        auto& lines = layouts.back().lines;
        std::string word;
        if (kind == "line") {
            line l;
            words >> l.first >> l.last >> l.left;
            if (layouts.size() - 1 != left_) l.glyphs = layouts[left_].lines[lines.size()].glyphs;
            lines.push_back(std::move(l));
        } else if (kind == "run") {
            std::string font;
            words >> font;
            while (words >> word) {
                std::string_view rest{word};
                const std::uint32_t id = whole(rest), at = whole(rest);
                lines.back().glyphs.push_back({font, id, at, number(rest)});
            }
        } else {
            double before = 0.0;  // what stands behind the last change has been moved by
            while (words >> word) {
                std::string_view rest{word};
                const std::size_t from = whole(rest);
                const double by = number(rest);
                for (std::size_t k = from; k < lines.back().glyphs.size(); ++k) lines.back().glyphs[k].x += by - before;
                before = by;
            }
        }
    }

    void add_place(const std::string& kind, std::istringstream& words)
    {
        layout& l = all_.texts.back().layouts.back();
        std::string word;
        if (kind == "hit") {
            hit h;
            words >> h.x >> h.line >> h.at >> word;
            h.upstream = word == "up";
            l.hits.push_back(h);
        } else if (kind == "box") {
            box b;
            words >> b.first >> b.last >> b.line >> word;
            std::string_view sides{word};
            b.left = number(sides);
            b.right = number(sides);
            l.boxes.push_back(b);
        } else if (kind == "grapheme") {
            grapheme g;
            words >> g.first >> g.last >> word;
            std::string_view sides{word};
            g.left = number(sides);
            g.right = number(sides);
            words >> word;
            g.to_the_left = word == "rtl";
            l.graphemes.push_back(g);
        } else {
            FAIL("recorded.txt has a line of an unknown kind: " << kind);
        }
    }

    std::ifstream in_;
    record all_;
    std::size_t left_ = 0;
};

}  // namespace skparagraph
