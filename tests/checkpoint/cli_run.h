// `cairn run` with checkpoints, in a temporary folder of the test.
#pragma once

#include "../scene/cli_program.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace cairn::test {

class CliRun : public Cli {
  protected:
    std::string bytes(const fs::path& file) const { return read_all(folder_ / file); }
    void put(const fs::path& file, const std::string& text) const {
        std::ofstream(folder_ / file, std::ios::binary | std::ios::trunc) << text;
    }
    // The summary of a run that must complete.
    nlohmann::json summary(const std::string& arguments) const { return summary_of(cairn("run --json " + arguments)); }
    static nlohmann::json summary_of(const Result& result) {
        EXPECT_EQ(result.code, 0) << result.out << result.err;
        return nlohmann::json::parse(result.out, nullptr, false);
    }
    // Compares the parts of the summary that must be equal for two runs with the same end.
    static void expect_same_end(const nlohmann::json& one, const nlohmann::json& other) {
        for (const char* name : {"hash", "steps", "max_penetration", "energy", "momentum", "contacts"})
            EXPECT_EQ(one.value(name, nlohmann::json()), other.value(name, nlohmann::json())) << name;
    }
    // A shell command that waits until there is a checkpoint, for at most 20 s.
    static constexpr const char* wait_for_a_checkpoint =
        "for i in $(seq 400); do ls ck/*/index.json >/dev/null 2>&1 && break; sleep 0.05; done\n";
};

} // namespace cairn::test
