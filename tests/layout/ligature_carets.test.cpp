// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/layout/ligature_carets.hpp>

namespace {

struct knowing {
    typemesh::error ligature_carets(std::uint32_t, typemesh::glyph_id, bool,
                                    typemesh::buffer<double>& carets) const noexcept
    {
        return carets.push_back(1.0) ? typemesh::error{} : typemesh::error{typemesh::error::out_of_memory};
    }
};

}  // namespace

TEST_CASE("shapers may know the carets of their ligatures", "[layout]")
{
    STATIC_REQUIRE(typemesh::has_ligature_carets<knowing>);
    STATIC_REQUIRE_FALSE(typemesh::has_ligature_carets<test::toy_shaper>);
}
