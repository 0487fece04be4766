// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/markup/impl/markup_reader.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

using namespace typemesh;

namespace {

detail::read_markup_tag<char> read_tag(std::string_view source) { return detail::markup_reader<char>{source}.read(0); }

}  // namespace

TEST_CASE("every tag has a name that its number finds", "[markup]")
{
    for (std::uint32_t i = 0; i < markup_tag_count; ++i) {
        const detail::markup_tag_form& form = detail::markup_tag_forms[i];
        INFO(form.name);
        CHECK(form.tag == static_cast<markup_tag>(i));
        const auto closing = read_tag("[/" + std::string{form.name} + "]x");
        CHECK(closing.form == &form);
        CHECK(closing.closes);
        CHECK(closing.end == form.name.size() + 3);
    }
}

TEST_CASE("a number of a tag is the double that the C library reads", "[markup]")
{
    for (const char* number : {"0", "-0", "1", "1000", "-1000", "0.1", "-0.3", ".7", "0.000001", "999.999999", "2.675",
                               "0000000000000000000001.5", "123.456789"}) {
        const auto tag = read_tag(std::string{"[rise="} + number + "]");
        INFO(number);
        REQUIRE(tag.mistake == nullptr);
        const double expected = std::strtod(number, nullptr) + 0.0, seen = tag.number + 0.0;
        CHECK(std::memcmp(&expected, &seen, sizeof seen) == 0);
    }
    for (const char* number : {"1000.000001", "-1000.000001", "99999999999999999999999999", "0.1234567", "0.0000000"})
        CHECK(std::string_view{read_tag(std::string{"[rise="} + number + "]").mistake} ==
              "a number out of range, or with more than six decimals");
    for (const char* number : {".", "-", "1.", "1..2", "+1", "1e3", "1,5", " 1", "0x1", "--1", "inf"})
        CHECK(std::string_view{read_tag(std::string{"[rise="} + number + "]").mistake} ==
              "a value that is not a number");
    CHECK(read_tag("[size=0]").mistake != nullptr);
    CHECK(read_tag("[depth=-0.1]").mistake != nullptr);
    CHECK(read_tag("[depth=0]").mistake == nullptr);
}
