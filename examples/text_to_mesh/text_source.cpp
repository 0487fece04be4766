// SPDX-License-Identifier: MIT
#include "text_source.hpp"

#include "atomic_file.hpp"
#include "option_values.hpp"

#include <cerrno>
#include <cstdio>
#include <map>
#include <system_error>
#include <utility>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#endif

namespace text_to_mesh {
namespace {

constexpr std::size_t max_bytes = std::size_t{64} << 20;  // else a device without an end fills the memory

/// A text as a part of a file's name, on any system.
std::string as_name(std::string_view text)
{
    constexpr std::string_view refused = "/\\:*?\"<>|";
    std::string name{text.substr(0, 100)};
    while (name.size() < text.size() && !name.empty() && (static_cast<unsigned char>(text[name.size()]) & 0xC0) == 0x80)
        name.pop_back();  // no half of a character
    for (char& c : name)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F || refused.find(c) != std::string_view::npos) c = '_';
    if (name.starts_with('.') || name.starts_with('-')) name[0] = '_';
    if (name.ends_with('.') || name.ends_with(' ')) name.back() = '_';
    return name;
}

void replace(std::string& in, std::string_view what, std::string_view by)
{
    for (std::size_t at = 0; (at = in.find(what, at)) != std::string::npos; at += by.size())
        in.replace(at, what.size(), by);
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t") == std::string_view::npos; }

}  // namespace

std::string read_file(const std::string& path, std::string& out, std::string_view advice)
{
    const bool piped = path == standard_output;  // "-": standard input here
    const std::string name = piped ? "standard input" : path;
    errno = 0;
    std::FILE* const file = piped ? stdin : std::fopen(path.c_str(), "rb");
    const auto refused = [&] {
        return name + " cannot be read: " + std::error_code{errno, std::generic_category()}.message() + ".";
    };
    if (file == nullptr) return refused();
#ifdef _WIN32
    if (piped) (void)_setmode(_fileno(stdin), _O_BINARY);
#endif
    char some[65536];
    for (std::size_t count = 1; count != 0 && out.size() <= max_bytes; out.append(some, count))
        count = std::fread(some, 1, sizeof some, file);
    std::string trouble = std::ferror(file) != 0 ? refused() : std::string{};
    if (out.size() > max_bytes)
        trouble = name + " contains more than 64 MB, which is too much for one mesh" + std::string{advice} + ".";
    if (!piped) std::fclose(file);
    if (!trouble.empty()) return trouble;
    if (out.starts_with("\xEF\xBB\xBF")) out.erase(0, 3);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (out[i] != '\r' || i + 1 == out.size() || out[i + 1] != '\n') out[kept++] = out[i];
    out.resize(kept);
    return {};
}

std::string file_name(std::string_view pattern, std::string_view text, std::size_t line, std::size_t last_line)
{
    std::string number = std::to_string(line), name{pattern};
    number.insert(0, std::to_string(last_line).size() - number.size(), '0');
    replace(name, "{n}", number);
    replace(name, "{text}", as_name(text));
    return name;
}

std::string refused_patterns(const options& o)
{
    for (const auto& [option, pattern] : {std::pair{"--output", &o.output}, std::pair{"--picture", &o.picture}}) {
        if (pattern->empty()) continue;
        if (pattern->find("{n}") == std::string::npos && pattern->find("{text}") == std::string::npos)
            return std::string{option} + " must contain {n} or {text} for --batch, for example tags/{n}.stl, not " +
                   *pattern;
    }
    return {};
}

std::string read_texts(const options& o, std::vector<text_job>& out)
{
    if (o.text_file.empty() && o.batch.empty()) {
        out.push_back({o.text, o.output, o.picture, 0});
        return {};
    }
    std::string all;
    if (std::string trouble = read_file(o.batch.empty() ? o.text_file : o.batch, all); !trouble.empty()) return trouble;
    if (all.ends_with('\n')) all.pop_back();
    if (o.batch.empty()) {
        out.push_back({all, o.output, o.picture, 0});
        return {};
    }
    std::vector<std::string_view> lines;
    for (std::string_view rest = all;;) {
        const auto end = rest.find('\n');
        lines.push_back(rest.substr(0, end));
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }
    std::map<std::string, std::size_t> made;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_blank(lines[i])) continue;
        text_job job{with_line_breaks(std::string{lines[i]}), {}, {}, i + 1};
        if (!o.output.empty()) job.output = file_name(o.output, lines[i], i + 1, lines.size());
        if (!o.picture.empty()) job.picture = file_name(o.picture, lines[i], i + 1, lines.size());
        for (const std::string& name : {job.output, job.picture}) {
            if (name.empty()) continue;
            const auto [before, fresh] = made.emplace(name, i + 1);
            if (!fresh)
                return "--batch: lines " + std::to_string(before->second) + " and " + std::to_string(i + 1) +
                       " would both make " + name + ".";
        }
        out.push_back(std::move(job));
    }
    return out.empty() ? "--batch: every line is blank." : std::string{};
}

}  // namespace text_to_mesh
