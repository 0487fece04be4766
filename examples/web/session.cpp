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
    maker_.take(options_);
}

typemesh::result<void> session::lay_out(std::u16string_view text)
{
    const text_to_mesh::options& o = options_;
    const typemesh::shape_options how{.direction = o.direction,
                                      .language = o.language,
                                      .script = o.script,
                                      .features = o.features,
                                      .columns = o.columns};
    typemesh::layout_options lines = o.lines;
    lines.ellipsis = how_.ellipsis;
    words_.breaker().is_even = o.even_lines;
    if (const auto done = words_.set(text, how, o.letter_spacing); !done) return done.error();
    return words_.lay_out(lines, page_);
}

typemesh::result<void> session::make(std::u16string_view text, bool instances)
{
    const auto begun = std::chrono::steady_clock::now();
    arrays_.clear();
    if (!how_.cached) cache_.clear();
    text_job job{.text = text, .page = nullptr, .instances = instances, .begun = begun};
    if (options_.page) {
        if (const auto done = lay_out(text); !done) return done.error();
        job.page = &page_;
    }
    const auto made = maker_.make(job, arrays_);
    if (!made) arrays_.clear();
    return made;
}

}  // namespace typemesh_web
