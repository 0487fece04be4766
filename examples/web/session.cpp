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
    if (const auto done = words_.set(text, shape_options_of(options_)); !done) return done.error();
    return words_.lay_out(lines, page_);
}

typemesh::result<void> session::make(std::u16string_view text, bool instances)
{
    const auto begun = std::chrono::steady_clock::now();
    arrays_.clear();
    if (!how_.cached) cache_.clear();
    text_job job{.text = text, .page = nullptr, .instances = instances, .letters = how_.letters, .begun = begun};
    typemesh::layout_options lines = options_.lines;
    lines.ellipsis = how_.ellipsis;
    if (how_.bend.fit_text() || typemesh::refused_in_plain_text(lines) == typemesh::error::needs_paragraph) {
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

const char* session::explained(const typemesh::error& e) const noexcept
{
    const bool is_tight = e == typemesh::error::bad_option && std::string_view{e.option} == "tolerance";
    if (!is_tight || !how_.bend.in_space()) return nullptr;
    return "The text is bent too tightly for its bevels: bend it less, or take narrower bevels or a lower "
           "quality.";
}

}  // namespace typemesh_web
