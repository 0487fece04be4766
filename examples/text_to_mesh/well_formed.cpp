// SPDX-License-Identifier: MIT
#include "well_formed.hpp"

#include <typemesh/unicode/utf.hpp>

#include <cstddef>

namespace text_to_mesh {

std::string well_formed(std::string_view name)
{
    std::string out;
    for (std::size_t i = 0; i < name.size();) {
        const typemesh::code_point c = typemesh::decode(name, i);
        if (c.valid)
            out += name.substr(i, c.next - i);
        else
            out += "\xEF\xBF\xBD";
        i = c.next;
    }
    return out;
}

}  // namespace text_to_mesh
