// cairn_scene_hashes FOLDER: prints as JSON, for each scene file in the folder, its name, its title and the hashes of
// its state after 60, 120, ... 600 steps on this machine. The playground compares its states with them.
#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: cairn_scene_hashes FOLDER\n";
        return 2;
    }
    try {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const std::filesystem::path& path : cairn::scene::scene_files(argv[1])) {
            cairn::scene::Scene scene = cairn::scene::load(path);
            nlohmann::ordered_json hashes = nlohmann::ordered_json::object();
            for (int step = 1; step <= 600; ++step) {
                scene.world.step(scene.info.time_step);
                if (step % 60 != 0) continue;
                char text[20];
                std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(scene.world.state_hash()));
                hashes[std::to_string(step)] = text;
            }
            list.push_back({{"name", path.stem().string()},
                            {"file", path.filename().string()},
                            {"title", scene.info.title},
                            {"hashes", std::move(hashes)}});
        }
        std::cout << list.dump(1) << "\n";
    } catch (const std::exception& error) {
        std::cerr << "cairn_scene_hashes: " << error.what() << "\n";
        return 1;
    }
    return std::cout.flush() ? 0 : 1;
}
