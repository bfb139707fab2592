#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/outputs.h"

#include "scene/mesh_store.h"
#include "scene/scene.h"

#include <cairn/error.h>

#include <string>
#include <vector>

namespace cairn::cli {

namespace {

scene::Scene load_any(const ConvertOptions& options) {
    if (scene::is_mesh_file(options.input)) {
        if (options.read.fixed_base) {
            throw Error(ErrorCode::unsupported, options.input.string(), {},
                        "must be a robot in URDF, MJCF or SDF for its base to be fixed");
        }
        scene::MeshImport import;
        import.as_hull = options.as_hull.value_or(true);
        import.decompose = options.read.decompose;
        import.scale = options.scale.value_or(1.0);
        import.density = static_cast<float>(options.density.value_or(1000.0));
        scene::Scene made =
            scene::scene_of_mesh(scene::load_mesh_file(options.input), import, options.input.stem().string());
        scene::add_mesh_looks(options.input, import.scale, made);
        if (options.read.floor) scene::add_floor(made);
        return made;
    }
    if (options.as_hull || options.scale || options.density) {
        throw Error(ErrorCode::invalid_value, options.input.string(), {},
                    "is a scene, and --as, --scale and --density are for .obj and .stl files");
    }
    return options.read.load(scene::find_scene(options.input.string()));
}

} // namespace

int convert_command(const ConvertOptions& options) {
    check_outputs(std::vector<Output>{{"out", options.output}});
    set_activity("reading", options.input.generic_string());
    const scene::Scene scene = load_any(options);
    print_warnings(scene.warnings);
    set_activity("writing", options.output.generic_string());
    scene::save(scene, options.output);
    return 0;
}

} // namespace cairn::cli
