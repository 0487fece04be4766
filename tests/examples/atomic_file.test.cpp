// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/atomic_file.hpp"

#include "scratch_folder.hpp"

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#include <unistd.h>
#define HAS_LIMITS 1
#endif

using text_to_mesh::file_set;
using text_to_mesh::write_atomically;

namespace {

const std::vector<unsigned char> some_bytes(100000, 0x5A);

bool is_sentence(const std::string& s, const std::string& path)
{
    return s.find(path) == 0 && s.back() == '.' && s.find('\n') == std::string::npos;
}

}  // namespace

TEST_CASE("a new file holds exactly the bytes and nothing else appears", "[atomic_file]")
{
    scratch_folder folder;
    CHECK(write_atomically(folder.file("new.bin"), some_bytes).empty());
    CHECK((bytes_of(folder.file("new.bin")) == some_bytes));
    CHECK(write_atomically(folder.file("empty.bin"), {}).empty());
    CHECK(bytes_of(folder.file("empty.bin")).empty());
    CHECK(write_atomically(folder.file(std::string(255, 'n')), some_bytes).empty());  // the longest name there can be
    CHECK(folder.count() == 3);
}

TEST_CASE("an existing file is replaced and keeps its permissions", "[atomic_file]")
{
    namespace fs = std::filesystem;
    scratch_folder folder;
    const std::string path = folder.file("old.bin");
    REQUIRE(write_atomically(path, std::vector<unsigned char>(7, 1)).empty());
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    CHECK(write_atomically(path, some_bytes).empty());
    CHECK((bytes_of(path) == some_bytes));
    CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
    CHECK(folder.count() == 1);
}

TEST_CASE("writing through a symbolic link changes the file it leads to and keeps the link", "[atomic_file]")
{
    namespace fs = std::filesystem;
    scratch_folder folder;
    REQUIRE(write_atomically(folder.file("target"), std::vector<unsigned char>(7, 1)).empty());
    std::error_code refused;
    fs::create_symlink("target", folder.file("link"), refused);
    if (refused) return;
    fs::create_symlink("not there yet", folder.file("dangling"), refused);
    CHECK(write_atomically(folder.file("link"), some_bytes).empty());
    CHECK(fs::is_symlink(folder.file("link")));
    CHECK((bytes_of(folder.file("target")) == some_bytes));
    CHECK(write_atomically(folder.file("dangling"), some_bytes).empty());
    CHECK((bytes_of(folder.file("not there yet")) == some_bytes));
    CHECK(folder.count() == 4);

    fs::create_symlink("round", folder.file("round"), refused);
    CHECK(is_sentence(write_atomically(folder.file("round"), some_bytes), folder.file("round")));
    CHECK(fs::is_symlink(fs::symlink_status(folder.file("round"))));
}

TEST_CASE("a place that takes no file is named in one sentence and stays as it was", "[atomic_file]")
{
    scratch_folder folder;
    const std::string missing = folder.file("no folder/out.glb");
    CHECK(is_sentence(write_atomically(missing, some_bytes), missing));

    REQUIRE(write_atomically(folder.file("plain"), some_bytes).empty());
    const std::string below_file = folder.file("plain/out.glb");
    CHECK(is_sentence(write_atomically(below_file, some_bytes), below_file));

    std::filesystem::create_directory(folder.file("folder"));
    CHECK(is_sentence(write_atomically(folder.file("folder"), some_bytes), folder.file("folder")));
    CHECK(std::filesystem::is_directory(folder.file("folder")));

    const std::string endless = folder.file(std::string(300, 'n'));
    CHECK(is_sentence(write_atomically(endless, some_bytes), endless));
    CHECK_FALSE(write_atomically("", some_bytes).empty());
    CHECK(folder.count() == 2);
}

#ifdef HAS_LIMITS
TEST_CASE("a write that fails halfway leaves the old file and no temporary", "[atomic_file]")
{
    scratch_folder folder;
    const std::vector<unsigned char> old(7, 1);
    REQUIRE(write_atomically(folder.file("old.bin"), old).empty());

    rlimit before{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    rlimit tight = before;
    tight.rlim_cur = 50000;
    REQUIRE(setrlimit(RLIMIT_FSIZE, &tight) == 0);
    const std::string replaced = write_atomically(folder.file("old.bin"), some_bytes);
    const std::string created = write_atomically(folder.file("new.bin"), some_bytes);
    REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);

    CHECK(is_sentence(replaced, folder.file("old.bin")));
    CHECK(is_sentence(created, folder.file("new.bin")));
    CHECK((bytes_of(folder.file("old.bin")) == old));
    CHECK(folder.count() == 1);
}

TEST_CASE("of several files all are written or none", "[atomic_file]")
{
    struct file {
        std::string path;
        std::vector<unsigned char> bytes;
    };
    const auto written = [](const file(&both)[2]) {
        file_set files;
        for (const file& f : both)
            if (std::string trouble = files.add(f.path, f.bytes); !trouble.empty()) return trouble;
        return files.finish();
    };
    scratch_folder folder;
    REQUIRE(written({{folder.file("one"), some_bytes}, {folder.file("two"), some_bytes}}).empty());
    CHECK((bytes_of(folder.file("one")) == some_bytes));
    CHECK((bytes_of(folder.file("two")) == some_bytes));

    std::filesystem::create_directory(folder.file("taken"));
    const file refused[][2] = {{{folder.file("new"), some_bytes}, {folder.file("taken"), some_bytes}},
                               {{folder.file("taken"), some_bytes}, {folder.file("new"), some_bytes}},
                               {{folder.file("one"), {}}, {folder.file("taken"), {}}},
                               {{"/dev/null", {}}, {folder.file("taken"), {}}}};
    for (const auto& two : refused) CHECK(is_sentence(written(two), folder.file("taken")));
    CHECK((bytes_of(folder.file("one")) == some_bytes));
    if (std::filesystem::is_character_file("/dev/full"))
        CHECK(is_sentence(written({{folder.file("one"), {}}, {"/dev/full", some_bytes}}), "/dev/full"));
    CHECK((bytes_of(folder.file("one")) == some_bytes));
    CHECK(folder.count() == 3);
}

TEST_CASE("a full disk is reported, and a device is written to but never replaced", "[atomic_file]")
{
    if (!std::filesystem::is_character_file("/dev/full")) {
        WARN("skipped: this system has no /dev/full");
        return;
    }
    const std::string told = write_atomically("/dev/full", some_bytes);
    CHECK(is_sentence(told, "/dev/full"));
    CHECK(told.find("No space left on device") != std::string::npos);
    CHECK(std::filesystem::is_character_file("/dev/full"));
    CHECK(write_atomically("/dev/null", some_bytes).empty());
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a file without write permission is refused", "[atomic_file]")
{
    if (geteuid() == 0) {
        WARN("skipped: the superuser may write to every file");
        return;
    }
    scratch_folder folder;
    REQUIRE(write_atomically(folder.file("kept"), some_bytes).empty());
    std::filesystem::permissions(folder.file("kept"), std::filesystem::perms::owner_read);
    CHECK(is_sentence(write_atomically(folder.file("kept"), {}), folder.file("kept")));
    CHECK((bytes_of(folder.file("kept")) == some_bytes));
}
#endif
