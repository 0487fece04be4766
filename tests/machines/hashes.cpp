// SPDX-License-Identifier: MIT
//
// Does this machine make what others make?
//
//     typemesh_hashes FOLDER            says of each stage of stages.hpp whether its hash is that of FOLDER/hashes.txt, and
//                                       fails if one is not; FOLDER/letters.txt has the letters
//     typemesh_hashes FOLDER --renew    writes hashes.txt, for a change of results that is meant

#include "stages.hpp"

#include <cinttypes>
#include <map>

namespace {

std::map<std::string, std::string> stored_in(const std::string& path)
{
    std::ifstream file{path};
    std::map<std::string, std::string> stored;  // by stage
    for (std::string line; std::getline(file, line);)
        if (!line.empty() && line[0] != '#' && line.size() > 18) stored[line.substr(18)] = line.substr(0, 16);
    if (stored.empty()) machines::stop(path + " cannot be read");
    return stored;
}

std::string text_of(std::uint64_t value)
{
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, value);
    return text;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2 || argc > 3) machines::stop("usage: typemesh_hashes FOLDER [--renew]");
    const std::string folder = argv[1];
    const auto stages = machines::hash_stages(machines::read_letters(folder + "/letters.txt"));
    if (argc == 3) {
        std::ofstream out{folder + "/hashes.txt"};
        out << "# What every machine makes of letters.txt, stage by stage: hashes.cpp --renew writes this.\n";
        for (const machines::stage_hash& s : stages) out << text_of(s.value) << "  " << s.stage << '\n';
        return out.flush() ? 0 : 2;
    }
    const auto stored = stored_in(folder + "/hashes.txt");
    int others = stored.size() == stages.size() ? 0 : 1;
    for (const machines::stage_hash& s : stages) {
        const auto same = stored.find(s.stage);
        const bool equal = same != stored.end() && same->second == text_of(s.value);
        others += equal ? 0 : 1;
        std::printf("%s  %8zu numbers  %s\n", equal ? "same " : "OTHER", s.numbers, s.stage.c_str());
    }
    return others == 0 ? 0 : 1;
}
