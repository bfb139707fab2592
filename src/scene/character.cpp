#include "scene/character.h"

#include "scene/json_number.h"

namespace cairn::scene {

namespace {

struct Member {
    const char* name;
    float CharacterDef::*value;
};
constexpr Member all_members[] = {
    {"max_slope", &CharacterDef::max_slope},
    {"step_height", &CharacterDef::step_height},
    {"stick_distance", &CharacterDef::stick_distance},
    {"skin", &CharacterDef::skin},
    {"mass", &CharacterDef::mass},
    {"max_push_force", &CharacterDef::max_push_force},
    {"air_acceleration", &CharacterDef::air_acceleration},
};

} // namespace

void read_character(const Value& here, Body body) {
    here.must_be_object();
    CharacterDef def;
    if (const auto up = here.find("up")) def.up = up->float_vector3();
    for (const Member& member : all_members)
        if (const auto value = here.find(member.name)) def.*member.value = value->real();
    if (const auto flies = here.find("flies")) def.flies = flies->boolean();
    try {
        body.set_character(def);
        if (const auto walk = here.find("walk_velocity")) body.set_walk_velocity(walk->float_vector3());
    } catch (const Error& error) {
        here.fail(error);
    }
}

nlohmann::ordered_json written_character(const Body& body) {
    const CharacterDef def = body.character(), usual;
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    if (def.up != usual.up) json["up"] = number_array(def.up);
    for (const Member& member : all_members)
        if (def.*member.value != usual.*member.value) json[member.name] = shortest(def.*member.value);
    if (def.flies) json["flies"] = true;
    if (body.walk_velocity() != Vec3(0.0f)) json["walk_velocity"] = number_array(body.walk_velocity());
    return json;
}

} // namespace cairn::scene
