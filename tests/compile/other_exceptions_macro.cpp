// SPDX-License-Identifier: MIT
//
// Compiled without __cpp_exceptions and with _CPPUNWIND, as Microsoft's compilers may name exceptions: what a container
// throws when memory runs out is an error of the sink all the same.
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <new>

using namespace typemesh;

namespace {

template <class T>
struct poor_array {
    using value_type = T;
    void resize(std::size_t) { throw std::bad_alloc{}; }
    T* data() { return nullptr; }
    std::size_t size() const { return 0; }
};

struct to_position {
    static constexpr auto wants = attribute::position;
    vec3 operator()(const surface_point<wants>& s) const noexcept { return s.position; }
};

}  // namespace

int main()
{
    poor_array<vec3> vertices;
    poor_array<std::uint32_t> indices;
    auto sink = into(vertices, indices, to_position{});
    return sink.begin({3, 1}) == error::out_of_memory ? 0 : 1;
}
