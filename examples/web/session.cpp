// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <chrono>
#include <utility>

namespace typemesh_web {

session::session(std::vector<shared_font> fonts) : fonts_{std::move(fonts)}, set_{fonts_.front()->font}
{
    for (std::size_t i = 1; i < fonts_.size(); ++i) (void)set_.add(fonts_[i]->font);
    set(settings{});
}

void session::set(const settings& how)
{
    how_ = how;
    options_ = how_.settled();
    options_.bend = how_.bend.choose(nullptr);
    maker_.take(options_);
}

typemesh::result<void> session::lay_out(std::u16string_view text, const typemesh::layout_options& lines)
{
    words_.breaker().is_even = options_.even_lines;
    typemesh::shape_options how = shape_options_of(options_);
    if (how_.markup)
        if (const typemesh::error e = tags_.add_to(how, set_)) return e;
    if (const auto done = words_.set(text, how); !done) return done.error();
    if (const auto done = words_.lay_out(lines, page_); !done || !how_.markup) return done;
    return tags_.write(words_, set_, page_);
}

typemesh::result<void> session::make(std::u16string_view text, bool instances)
{
    const auto begun = std::chrono::steady_clock::now();
    arrays_.clear();
    if (!how_.cached) cache_.clear();
    if (how_.markup) {
        if (const auto done = tags_.read(text, fonts_.size()); !done) return done;
        text = tags_.text();
    }
    text_job job{.text = text, .letters = how_.letters, .marked = how_.markup ? &tags_ : nullptr, .begun = begun};
    job.instances = instances;
    typemesh::layout_options lines = options_.lines;
    lines.ellipsis = how_.ellipsis;
    const bool needs_page = typemesh::refused_in_plain_text(lines) == typemesh::error::needs_paragraph;
    if (how_.markup || how_.bend.fit_text() || needs_page) {
        if (const auto done = lay_out(text, lines); !done) return done.error();
        job.page = &page_;
    }
    if (how_.bend.fit_text()) {
        options_.bend = how_.bend.choose(&page_);
        maker_.take(options_);
    }
    const auto made = maker_.make(job, arrays_);
    if (!made) arrays_.clear();
    return made;
}

typemesh::result<void> session::plan_morph(std::u16string_view text, const char (&axis)[5])
{
    arrays_.clear();
    morph_ = nullptr;
    if (how_.markup) {
        if (const auto done = tags_.read(text, fonts_.size()); !done) return done;
        text = tags_.text();
    }
    auto found = typemesh::harfbuzz_axis::open(fonts_.front()->font, axis);
    if (!found) return found.error();
    auto made = std::make_unique<weight_morph>(std::move(*found));
    const auto done = made->plan(text, options_);
    if (done) morph_ = std::move(made);
    return done;
}

const char* session::explained(const typemesh::error& e)
{
    using typemesh::error;
    if (e == error::bad_markup)
        return (sentence_ = std::string{"There is "} + e.option + "; write [[ for a bracket.").c_str();
    if (e == error::no_such_face && how_.markup) return "[font=...] is the number of a font: 1, 2 and so on.";
    const bool is_tight = e == error::bad_option && std::string_view{e.option} == "tolerance";
    if (!is_tight || !how_.bend.in_space()) return nullptr;
    return "The text is bent too tightly for its bevels: bend it less, or take narrower bevels or a lower "
           "quality.";
}

}  // namespace typemesh_web
