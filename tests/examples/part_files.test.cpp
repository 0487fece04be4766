// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/atomic_file.hpp"
#include "text_to_mesh/part_files.hpp"

#include "scratch_folder.hpp"

#include <vector>

using text_to_mesh::part_file;

TEST_CASE("a part file is there until it is moved or discarded", "[part_files]")
{
    scratch_folder folder;
    {
        part_file part;
        std::FILE* const file = part.open(folder.file(""));
        REQUIRE(file != nullptr);
        std::fclose(file);
        CHECK(folder.count() == 1);
        CHECK(std::filesystem::exists(part.path()));
        CHECK_FALSE(part.move_to(folder.file("whole")));
        CHECK(part.path().empty());
        std::FILE* const second = part.open(folder.file(""));
        REQUIRE(second != nullptr);
        std::fclose(second);
        CHECK(folder.count() == 2);
    }
    CHECK(folder.count() == 1);
    part_file nowhere;
    CHECK(nowhere.open(folder.file("no folder")) == nullptr);
    CHECK(nowhere.path().empty());
}

#ifndef _WIN32
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

namespace {

/// A child that holds more part files than one and waits, until a signal ends it. Gives how waitpid() says it ended.
int ended_by(int signal, const scratch_folder& folder, bool ignored)
{
    int ready[2];
    REQUIRE(pipe(ready) == 0);
    const pid_t child = fork();
    if (child == 0) {
        std::signal(signal, ignored ? SIG_IGN : SIG_DFL);
        const std::vector<unsigned char> bytes(100000, 1);
        text_to_mesh::file_set files;
        bool fine = files.add(folder.file("one"), bytes).empty() && files.add(folder.file("two"), bytes).empty();
        fine = write(ready[1], fine ? "y" : "n", 1) == 1 && fine;
        if (ignored) {
            raise(signal);
            _exit(files.finish().empty() ? 7 : 8);
        }
        for (;;) pause();
    }
    char said = 0;
    REQUIRE(read(ready[0], &said, 1) == 1);
    CHECK(said == 'y');
    if (!ignored) {
        CHECK(folder.count() == 2);
        kill(child, signal);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    close(ready[0]);
    close(ready[1]);
    return status;
}

}  // namespace

TEST_CASE("signals that end the program leave no part file, and end it", "[part_files]")
{
    const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
    scratch_folder folder;
    const int status = ended_by(signal, folder, false);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.count() == 0);
}

TEST_CASE("a signal that is ignored stays ignored, as by nohup", "[part_files]")
{
    scratch_folder folder;
    const int status = ended_by(SIGHUP, folder, true);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 7);
    CHECK(folder.count() == 2);
}
#endif
