/* A program in C99 that uses Cairn: it drops a crate onto the ground and prints its final height. */
#include <cairn/cairn.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failed(cairn_result result) {
    if (result != CAIRN_OK) printf("%s\n", cairn_last_error());
    return result != CAIRN_OK;
}

int main(void) {
    cairn_world* world;
    cairn_body_id ground, crate;
    cairn_shape_id shape;
    cairn_body_def def = cairn_default_body_def();
    cairn_shape_def shape_def = cairn_default_shape_def();
    cairn_shape plane = cairn_default_shape(CAIRN_SHAPE_PLANE), box = cairn_default_shape(CAIRN_SHAPE_BOX);
    cairn_position position;
    if (failed(cairn_world_create(NULL, &world)) || failed(cairn_world_set_threads(world, 2))) return 1;
    def.type = CAIRN_BODY_TYPE_STATIC;
    if (failed(cairn_world_create_body(world, &def, &ground))) return 1;
    if (failed(cairn_world_add_shape(world, ground, &plane, NULL, &shape))) return 1;
    def = cairn_default_body_def();
    def.position.y = 5;
    shape_def.density = 600;
    if (failed(cairn_world_create_body(world, &def, &crate))) return 1;
    if (failed(cairn_world_add_shape(world, crate, &box, &shape_def, &shape))) return 1;
    if (failed(cairn_world_steps(world, 1.0f / 60, 600))) return 1;
    if (failed(cairn_body_get_position(world, crate, &position))) return 1;
    printf("cairn %s: the crate lies at %.4f m\n", cairn_version(), position.y);
    if (cairn_world_step(world, NAN) != CAIRN_ERROR_INVALID_VALUE) return 1;
    printf("a step that is refused: %s\n", cairn_last_error());
    cairn_world_destroy(world);
    if (cairn_abi_version() != CAIRN_ABI_VERSION) return 1;
    if (strcmp(cairn_version(), PACKAGE_VERSION) != 0) {
        printf("the package says that it is %s\n", PACKAGE_VERSION);
        return 1;
    }
    return fabs(position.y - 0.5) < 0.005 ? 0 : 1;
}
