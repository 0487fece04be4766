// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/text_source.hpp"

#include "scratch_folder.hpp"

#include <fstream>

using namespace text_to_mesh;

namespace {

void put(const std::string& path, const std::string& bytes) { std::ofstream{path, std::ios::binary} << bytes; }

}  // namespace

TEST_CASE("a pattern names a file for each line, on any system", "[text_source]")
{
    CHECK(file_name("{n}.stl", "x", 7, 9) == "7.stl");
    CHECK(file_name("{n}.stl", "x", 7, 120) == "007.stl");
    CHECK(file_name("a/{text}-{n}{n}.glb", "Anna", 1, 1) == "a/Anna-11.glb");
    CHECK(file_name("{text}", "a/b\\c:d*e?f\"g<h>i|j\nk\x7F", 1, 1) == "a_b_c_d_e_f_g_h_i_j_k_");
    CHECK(file_name("{text}", "../x. ", 1, 1) == "_._x._");
    CHECK(file_name("{text}", "-x", 1, 1) == "_x");
    CHECK(file_name("{text}", "{n}{text}", 1, 1) == "{n}{text}");
    std::string long_text = "a";
    for (int i = 0; i < 80; ++i) long_text += "\xC3\xA4";
    CHECK(file_name("{text}", long_text, 1, 1) == long_text.substr(0, 99));  // no half of a character
}

TEST_CASE("texts are read from files as editors of any system write them", "[text_source]")
{
    scratch_folder folder;
    options o;
    o.text_file = folder.file("text");
    o.output = "x.glb";
    const auto text_of_file = [&](const std::string& bytes) {
        put(o.text_file, bytes);
        std::vector<text_job> jobs;
        CHECK(read_texts(o, jobs).empty());
        REQUIRE(jobs.size() == 1);
        CHECK(jobs[0].output == "x.glb");
        return jobs[0].text;
    };
    CHECK(text_of_file("").empty());
    CHECK(text_of_file("a") == "a");
    CHECK(text_of_file("a\nb\n") == "a\nb");
    CHECK(text_of_file("\xEF\xBB\xBF"
                       "a\r\nb\r\n") == "a\nb");
    CHECK(text_of_file("a\rb\r") == "a\rb\r");
    CHECK(text_of_file("@a\\nb\n\n") == "@a\\nb\n");
    const std::string large(200'000, 'x');
    CHECK(text_of_file(large) == large);
    CHECK(text_of_file(std::string{"a\0b", 3}) == std::string{"a\0b", 3});
}

TEST_CASE("a batch is a text a line, and two lines never make one file", "[text_source]")
{
    scratch_folder folder;
    options o;
    o.batch = folder.file("lines");
    o.output = "{text}.glb";
    const auto jobs_of = [&](const std::string& bytes, std::string& trouble) {
        put(o.batch, bytes);
        std::vector<text_job> jobs;
        trouble = read_texts(o, jobs);
        return jobs;
    };
    std::string trouble;
    const auto jobs = jobs_of("a\\nb\r\n\r\n\t\r\n-\r\n", trouble);
    CHECK(trouble.empty());
    REQUIRE(jobs.size() == 2);
    CHECK(jobs[0].text == "a\nb");
    CHECK(jobs[0].output == "a_nb.glb");
    CHECK(jobs[0].line == 1);
    CHECK(jobs[1].text == "-");
    CHECK(jobs[1].output == "_.glb");
    CHECK(jobs[1].line == 4);
    jobs_of("x/\nx:\n", trouble);
    CHECK(trouble == "--batch: lines 1 and 2 would both make x_.glb.");
    jobs_of("", trouble);
    CHECK(trouble == "--batch: every line is blank.");
    o.batch = folder.file("nothing");
    std::vector<text_job> none;
    CHECK(read_texts(o, none).find("nothing cannot be read: ") != std::string::npos);
}
