// The program in a temporary folder with a plan for a sweep.
#pragma once

#include "../scene/cli_program.h"

namespace cairn::test {

class CliSweep : public Cli {
  protected:
    // Boxes and balls on slopes, with varying friction and gravity.
    void write_plan(int rows, double seconds = 0.5) const {
        std::ofstream(folder_ / "plan.json") << R"({"scene": "slopes",
            "parameters": [{"name": "mu", "from": 0.1, "to": 0.9}, {"name": "g", "from": 2, "to": 20}],
            "sample": {"sobol": )" << rows << R"(}, "seconds": )"
                                             << seconds << R"(,
            "set": {"bodies[2].friction": "mu", "world.gravity.y": "-g"},
            "stop": "bodies[2].position.z > 3",
            "measure": [{"name": "z", "of": "bodies[2].position.z"}, {"name": "energy", "of": "world.energy"},
                        {"name": "rest", "of": "'box, friction 0.1'.speed < 0.01", "take": "since"}]})";
    }
    std::string bytes(const std::string& file) const { return read_all(folder_ / file); }
};

} // namespace cairn::test
