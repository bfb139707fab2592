// Made by tools/api.py from api/: change those, and run it.
// The calls of World and Body that say nothing but what the table says; web/src/world.js has the others.
import { M, ALL_LAYERS, boolOf, check, enter, handleOf, indexOf, leave, listOf, numberOf, placed, room, textAt, textOf, u64Of,
    use, wholeOf } from '../memory.js';
import * as fields from '../fields.js';
import * as values from './values.js';

export class WorldCalls {
    addShape(body, shape, definition = {}) {
        const mark = enter();
        try {
            const $body = handleOf(body, 'body');
            const $shape = room(100);
            values.putShape($shape, shape, 'Shape');
            const $def = room(120);
            M._cairn_default_shape_def($def);
            values.putShapeDef($def, definition, 'ShapeDef');
            const out = room(8);
            check(M._cairn_world_add_shape(use(this), $body[0], $body[1], $shape, $def, out));
            return fields.getU64(out);
        } finally {
            leave(mark);
        }
    }

    removeShape(shape) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            check(M._cairn_world_remove_shape(use(this), $shape[0], $shape[1]));
        } finally {
            leave(mark);
        }
    }

    setShape(shape, geometry) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const $geometry = room(100);
            values.putShape($geometry, geometry, 'Shape');
            check(M._cairn_world_set_shape(use(this), $shape[0], $shape[1], $geometry));
        } finally {
            leave(mark);
        }
    }

    setShapeDef(shape, definition) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const $def = room(120);
            M._cairn_default_shape_def($def);
            values.putShapeDef($def, definition, 'ShapeDef');
            check(M._cairn_world_set_shape_def(use(this), $shape[0], $shape[1], $def));
        } finally {
            leave(mark);
        }
    }

    bodyOf(shape) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const out = room(8);
            check(M._cairn_shape_get_body(use(this), $shape[0], $shape[1], out));
            return fields.getU64(out);
        } finally {
            leave(mark);
        }
    }

    shape(shape) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const out = room(100);
            check(M._cairn_world_get_shape(use(this), $shape[0], $shape[1], out));
            return values.getShape(out);
        } finally {
            leave(mark);
        }
    }

    shapeDef(shape) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const out = room(120);
            M._cairn_default_shape_def(out);
            check(M._cairn_world_get_shape_def(use(this), $shape[0], $shape[1], out));
            return values.getShapeDef(out);
        } finally {
            leave(mark);
        }
    }

    shapeTransform(shape) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const out = room(40);
            check(M._cairn_world_get_shape_transform(use(this), $shape[0], $shape[1], out));
            return values.getTransform(out);
        } finally {
            leave(mark);
        }
    }

    shapeBounds(shape) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const out = room(48);
            check(M._cairn_world_get_shape_bounds(use(this), $shape[0], $shape[1], out));
            return values.getBounds(out);
        } finally {
            leave(mark);
        }
    }

    setMaterial(shape, material) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const $material = room(28);
            M._cairn_default_material($material);
            values.putMaterial($material, material, 'Material');
            check(M._cairn_world_set_material(use(this), $shape[0], $shape[1], $material));
        } finally {
            leave(mark);
        }
    }

    setFilter(shape, filter) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const $filter = room(16);
            M._cairn_default_collision_filter($filter);
            values.putCollisionFilter($filter, filter, 'CollisionFilter');
            check(M._cairn_world_set_filter(use(this), $shape[0], $shape[1], $filter));
        } finally {
            leave(mark);
        }
    }

    setSurfaceVelocity(shape, velocity) {
        const mark = enter();
        try {
            const $shape = handleOf(shape, 'shape');
            const $velocity = room(12);
            fields.putVec3($velocity, velocity, 'velocity');
            check(M._cairn_world_set_surface_velocity(use(this), $shape[0], $shape[1], $velocity));
        } finally {
            leave(mark);
        }
    }

    get bodies() {
        const mark = enter();
        try {
            return listOf(8, (list, capacity, count) => M._cairn_world_get_bodies(use(this), list, capacity, count), (at) => fields.getU64(at));
        } finally {
            leave(mark);
        }
    }

    findBody(name) {
        const mark = enter();
        try {
            const $name = textAt(name, 'name');
            const out = room(8), found = room(1);
            check(M._cairn_world_find_body(use(this), $name, out, found));
            return fields.getBool(found) ? fields.getU64(out) : null;
        } finally {
            leave(mark);
        }
    }

    createJoint(definition) {
        const mark = enter();
        try {
            const $def = room(664);
            M._cairn_default_joint_def($def);
            values.putJointDef($def, definition, 'JointDef');
            const out = room(8);
            check(M._cairn_world_create_joint(use(this), $def, out));
            return fields.getU64(out);
        } finally {
            leave(mark);
        }
    }

    destroyJoint(joint) {
        const mark = enter();
        try {
            const $joint = handleOf(joint, 'joint');
            check(M._cairn_world_destroy_joint(use(this), $joint[0], $joint[1]));
        } finally {
            leave(mark);
        }
    }

    setJoint(id, joint) {
        const mark = enter();
        try {
            const $id = handleOf(id, 'id');
            const $joint = room(520);
            values.putJoint($joint, joint, 'Joint');
            check(M._cairn_world_set_joint(use(this), $id[0], $id[1], $joint));
        } finally {
            leave(mark);
        }
    }

    setJointStrength(joint, breakForce, breakTorque) {
        const mark = enter();
        try {
            const $joint = handleOf(joint, 'joint');
            const $breakForce = numberOf(breakForce, 'breakForce');
            const $breakTorque = numberOf(breakTorque, 'breakTorque');
            check(M._cairn_world_set_joint_strength(use(this), $joint[0], $joint[1], $breakForce, $breakTorque));
        } finally {
            leave(mark);
        }
    }

    setJointEnabled(joint, enabled) {
        const mark = enter();
        try {
            const $joint = handleOf(joint, 'joint');
            const $enabled = boolOf(enabled, 'enabled');
            check(M._cairn_world_set_joint_enabled(use(this), $joint[0], $joint[1], $enabled));
        } finally {
            leave(mark);
        }
    }

    jointState(joint) {
        const mark = enter();
        try {
            const $joint = handleOf(joint, 'joint');
            const out = room(68);
            check(M._cairn_world_get_joint_state(use(this), $joint[0], $joint[1], out));
            return values.getJointState(out);
        } finally {
            leave(mark);
        }
    }

    get joints() {
        const mark = enter();
        try {
            return listOf(8, (list, capacity, count) => M._cairn_world_get_joints(use(this), list, capacity, count), (at) => fields.getU64(at));
        } finally {
            leave(mark);
        }
    }

    findJoint(name) {
        const mark = enter();
        try {
            const $name = textAt(name, 'name');
            const out = room(8), found = room(1);
            check(M._cairn_world_find_joint(use(this), $name, out, found));
            return fields.getBool(found) ? fields.getU64(out) : null;
        } finally {
            leave(mark);
        }
    }

    castRay(origin, direction, maxDistance, filter = {}) {
        const mark = enter();
        try {
            const $origin = room(24);
            fields.putPosition($origin, origin, 'origin');
            const $direction = room(12);
            fields.putVec3($direction, direction, 'direction');
            const $maxDistance = numberOf(maxDistance, 'maxDistance');
            const $filter = room(40);
            M._cairn_default_query_filter($filter);
            values.putQueryFilter($filter, filter, 'QueryFilter');
            const out = room(72), found = room(1);
            check(M._cairn_world_cast_ray(use(this), $origin, $direction, $maxDistance, $filter, out, found));
            return fields.getBool(found) ? values.getRayHit(out) : null;
        } finally {
            leave(mark);
        }
    }

    castRayAll(origin, direction, maxDistance, filter = {}) {
        const mark = enter();
        try {
            const $origin = room(24);
            fields.putPosition($origin, origin, 'origin');
            const $direction = room(12);
            fields.putVec3($direction, direction, 'direction');
            const $maxDistance = numberOf(maxDistance, 'maxDistance');
            const $filter = room(40);
            M._cairn_default_query_filter($filter);
            values.putQueryFilter($filter, filter, 'QueryFilter');
            return listOf(72, (list, capacity, count) => M._cairn_world_cast_ray_all(use(this), $origin, $direction, $maxDistance, $filter, list, capacity, count), (at) => values.getRayHit(at));
        } finally {
            leave(mark);
        }
    }

    castShape(shape, start, translation, filter = {}) {
        const mark = enter();
        try {
            const $shape = room(100);
            values.putShape($shape, shape, 'Shape');
            const $start = room(40);
            M._cairn_default_transform($start);
            values.putTransform($start, start, 'Transform');
            const $translation = room(12);
            fields.putVec3($translation, translation, 'translation');
            const $filter = room(40);
            M._cairn_default_query_filter($filter);
            values.putQueryFilter($filter, filter, 'QueryFilter');
            const out = room(64), found = room(1);
            check(M._cairn_world_cast_shape(use(this), $shape, $start, $translation, $filter, out, found));
            return fields.getBool(found) ? values.getShapeCastHit(out) : null;
        } finally {
            leave(mark);
        }
    }

    closestPoint(point, maxDistance, filter = {}) {
        const mark = enter();
        try {
            const $point = room(24);
            fields.putPosition($point, point, 'point');
            const $maxDistance = numberOf(maxDistance, 'maxDistance');
            const $filter = room(40);
            M._cairn_default_query_filter($filter);
            values.putQueryFilter($filter, filter, 'QueryFilter');
            const out = room(56), found = room(1);
            check(M._cairn_world_closest_point(use(this), $point, $maxDistance, $filter, out, found));
            return fields.getBool(found) ? values.getClosestPoint(out) : null;
        } finally {
            leave(mark);
        }
    }

    overlap(shape, pose, filter = {}) {
        const mark = enter();
        try {
            const $shape = room(100);
            values.putShape($shape, shape, 'Shape');
            const $pose = room(40);
            M._cairn_default_transform($pose);
            values.putTransform($pose, pose, 'Transform');
            const $filter = room(40);
            M._cairn_default_query_filter($filter);
            values.putQueryFilter($filter, filter, 'QueryFilter');
            return listOf(8, (list, capacity, count) => M._cairn_world_overlap(use(this), $shape, $pose, $filter, list, capacity, count), (at) => fields.getU64(at));
        } finally {
            leave(mark);
        }
    }

    overlapBounds(bounds, filter = {}) {
        const mark = enter();
        try {
            const $bounds = room(48);
            M._cairn_default_bounds($bounds);
            values.putBounds($bounds, bounds, 'Bounds');
            const $filter = room(40);
            M._cairn_default_query_filter($filter);
            values.putQueryFilter($filter, filter, 'QueryFilter');
            return listOf(8, (list, capacity, count) => M._cairn_world_overlap_bounds(use(this), $bounds, $filter, list, capacity, count), (at) => fields.getU64(at));
        } finally {
            leave(mark);
        }
    }

    broadPhaseNodes(maxDepth, maxCount) {
        const mark = enter();
        try {
            const $maxDepth = wholeOf(maxDepth, 'maxDepth');
            const $maxCount = wholeOf(maxCount, 'maxCount');
            return listOf(72, (list, capacity, count) => M._cairn_world_broad_phase_nodes(use(this), $maxDepth, $maxCount, list, capacity, count), (at) => values.getBroadPhaseNode(at));
        } finally {
            leave(mark);
        }
    }

    get solverContacts() {
        const mark = enter();
        try {
            return listOf(40, (list, capacity, count) => M._cairn_world_solver_contacts(use(this), list, capacity, count), (at) => values.getSolverContact(at));
        } finally {
            leave(mark);
        }
    }

    debugLines(what = {}) {
        const mark = enter();
        try {
            const $what = room(20);
            M._cairn_default_debug_lines_def($what);
            values.putDebugLinesDef($what, what, 'DebugLinesDef');
            return listOf(64, (list, capacity, count) => M._cairn_world_debug_lines(use(this), $what, list, capacity, count), (at) => values.getDebugLine(at));
        } finally {
            leave(mark);
        }
    }

    get contactBegins() {
        const mark = enter();
        try {
            return listOf(32, (list, capacity, count) => M._cairn_world_get_contact_begins(use(this), list, capacity, count), (at) => values.getContactBegin(at));
        } finally {
            leave(mark);
        }
    }

    get contactEnds() {
        const mark = enter();
        try {
            return listOf(32, (list, capacity, count) => M._cairn_world_get_contact_ends(use(this), list, capacity, count), (at) => values.getContactEnd(at));
        } finally {
            leave(mark);
        }
    }

    get contactHits() {
        const mark = enter();
        try {
            return listOf(80, (list, capacity, count) => M._cairn_world_get_contact_hits(use(this), list, capacity, count), (at) => values.getContactHit(at));
        } finally {
            leave(mark);
        }
    }

    get triggerEvents() {
        const mark = enter();
        try {
            return listOf(40, (list, capacity, count) => M._cairn_world_get_trigger_events(use(this), list, capacity, count), (at) => values.getTriggerEvent(at));
        } finally {
            leave(mark);
        }
    }

    get jointEvents() {
        const mark = enter();
        try {
            return listOf(48, (list, capacity, count) => M._cairn_world_get_joint_events(use(this), list, capacity, count), (at) => values.getJointEvent(at));
        } finally {
            leave(mark);
        }
    }

    get sleepEvents() {
        const mark = enter();
        try {
            return listOf(16, (list, capacity, count) => M._cairn_world_get_sleep_events(use(this), list, capacity, count), (at) => values.getSleepEvent(at));
        } finally {
            leave(mark);
        }
    }

    get contacts() {
        const mark = enter();
        try {
            return listOf(200, (list, capacity, count) => M._cairn_world_get_contacts(use(this), list, capacity, count), (at) => values.getContact(at));
        } finally {
            leave(mark);
        }
    }

    get settings() {
        const mark = enter();
        try {
            const out = room(60);
            M._cairn_default_world_def(out);
            check(M._cairn_world_get_settings(use(this), out));
            return values.getWorldDef(out);
        } finally {
            leave(mark);
        }
    }

    set settings(definition) {
        const mark = enter();
        try {
            const $def = room(60);
            M._cairn_default_world_def($def);
            values.putWorldDef($def, definition, 'WorldDef');
            check(M._cairn_world_set_settings(use(this), $def));
        } finally {
            leave(mark);
        }
    }

    usualSubsteps(dt) {
        const mark = enter();
        try {
            const $dt = numberOf(dt, 'dt');
            const out = room(4);
            check(M._cairn_world_usual_substeps(use(this), $dt, out));
            return fields.getInt(out);
        } finally {
            leave(mark);
        }
    }

    get threads() {
        const mark = enter();
        try {
            const out = room(4);
            check(M._cairn_world_get_threads(use(this), out));
            return fields.getInt(out);
        } finally {
            leave(mark);
        }
    }

    set threads(count) {
        const mark = enter();
        try {
            const $count = wholeOf(count, 'count');
            check(M._cairn_world_set_threads(use(this), $count));
        } finally {
            leave(mark);
        }
    }

    addForceField(field) {
        const mark = enter();
        try {
            const $field = room(96);
            M._cairn_default_force_field($field);
            values.putForceField($field, field, 'ForceField');
            const out = room(8);
            check(M._cairn_world_add_force_field(use(this), $field, out));
            return fields.getU64(out);
        } finally {
            leave(mark);
        }
    }

    setForceField(id, field) {
        const mark = enter();
        try {
            const $id = handleOf(id, 'id');
            const $field = room(96);
            M._cairn_default_force_field($field);
            values.putForceField($field, field, 'ForceField');
            check(M._cairn_world_set_force_field(use(this), $id[0], $id[1], $field));
        } finally {
            leave(mark);
        }
    }

    removeForceField(id) {
        const mark = enter();
        try {
            const $id = handleOf(id, 'id');
            check(M._cairn_world_remove_force_field(use(this), $id[0], $id[1]));
        } finally {
            leave(mark);
        }
    }

    forceField(id) {
        const mark = enter();
        try {
            const $id = handleOf(id, 'id');
            const out = room(96);
            M._cairn_default_force_field(out);
            check(M._cairn_world_get_force_field(use(this), $id[0], $id[1], out));
            return values.getForceField(out);
        } finally {
            leave(mark);
        }
    }

    get forceFields() {
        const mark = enter();
        try {
            return listOf(8, (list, capacity, count) => M._cairn_world_get_force_fields(use(this), list, capacity, count), (at) => fields.getU64(at));
        } finally {
            leave(mark);
        }
    }

    get stepCount() {
        const mark = enter();
        try {
            const out = room(8);
            check(M._cairn_world_get_step_count(use(this), out));
            return fields.getU64(out);
        } finally {
            leave(mark);
        }
    }

    get time() {
        const mark = enter();
        try {
            const out = room(8);
            check(M._cairn_world_get_time(use(this), out));
            return fields.getDouble(out);
        } finally {
            leave(mark);
        }
    }

    get kineticEnergy() {
        const mark = enter();
        try {
            const out = room(8);
            check(M._cairn_world_get_kinetic_energy(use(this), out));
            return fields.getDouble(out);
        } finally {
            leave(mark);
        }
    }

    get potentialEnergy() {
        const mark = enter();
        try {
            const out = room(8);
            check(M._cairn_world_get_potential_energy(use(this), out));
            return fields.getDouble(out);
        } finally {
            leave(mark);
        }
    }

    get linearMomentum() {
        const mark = enter();
        try {
            const out = room(24);
            check(M._cairn_world_get_linear_momentum(use(this), out));
            return fields.getDVec3(out);
        } finally {
            leave(mark);
        }
    }

    get angularMomentum() {
        const mark = enter();
        try {
            const out = room(24);
            check(M._cairn_world_get_angular_momentum(use(this), out));
            return fields.getDVec3(out);
        } finally {
            leave(mark);
        }
    }

    get stateHash() {
        const mark = enter();
        try {
            const out = room(8);
            check(M._cairn_world_get_state_hash(use(this), out));
            return fields.getU64(out);
        } finally {
            leave(mark);
        }
    }

    get statistics() {
        const mark = enter();
        try {
            const out = room(168);
            M._cairn_default_statistics(out);
            check(M._cairn_world_get_statistics(use(this), out));
            return values.getStatistics(out);
        } finally {
            leave(mark);
        }
    }
}

export class BodyCalls {
    get type() {
        const mark = enter();
        try {
            const out = room(4);
            check(M._cairn_body_get_type(use(this.world), this.low, this.high, out));
            return values.BODY_TYPE[fields.getInt(out)];
        } finally {
            leave(mark);
        }
    }

    set type(type) {
        const mark = enter();
        try {
            const $type = indexOf(values.BODY_TYPE, type, 'type');
            check(M._cairn_body_set_type(use(this.world), this.low, this.high, $type));
        } finally {
            leave(mark);
        }
    }

    get name() {
        const mark = enter();
        try {
            return textOf((text, capacity, length) => M._cairn_body_get_name(use(this.world), this.low, this.high, text, capacity, length));
        } finally {
            leave(mark);
        }
    }

    set name(name) {
        const mark = enter();
        try {
            const $name = textAt(name, 'name');
            check(M._cairn_body_set_name(use(this.world), this.low, this.high, $name));
        } finally {
            leave(mark);
        }
    }

    get userData() {
        const mark = enter();
        try {
            const out = room(8);
            check(M._cairn_body_get_user_data(use(this.world), this.low, this.high, out));
            return fields.getU64(out);
        } finally {
            leave(mark);
        }
    }

    get position() {
        const mark = enter();
        try {
            const out = room(24);
            check(M._cairn_body_get_position(use(this.world), this.low, this.high, out));
            return fields.getPosition(out);
        } finally {
            leave(mark);
        }
    }

    set position(position) {
        const mark = enter();
        try {
            const $position = room(24);
            fields.putPosition($position, position, 'position');
            check(M._cairn_body_set_position(use(this.world), this.low, this.high, $position));
        } finally {
            leave(mark);
        }
    }

    get rotation() {
        const mark = enter();
        try {
            const out = room(16);
            check(M._cairn_body_get_rotation(use(this.world), this.low, this.high, out));
            return fields.getQuat(out);
        } finally {
            leave(mark);
        }
    }

    set rotation(rotation) {
        const mark = enter();
        try {
            const $rotation = room(16);
            fields.putQuat($rotation, rotation, 'rotation');
            check(M._cairn_body_set_rotation(use(this.world), this.low, this.high, $rotation));
        } finally {
            leave(mark);
        }
    }

    get transform() {
        const mark = enter();
        try {
            const out = room(40);
            check(M._cairn_body_get_transform(use(this.world), this.low, this.high, out));
            return values.getTransform(out);
        } finally {
            leave(mark);
        }
    }

    get centerOfMass() {
        const mark = enter();
        try {
            const out = room(24);
            check(M._cairn_body_get_center_of_mass(use(this.world), this.low, this.high, out));
            return fields.getPosition(out);
        } finally {
            leave(mark);
        }
    }

    get linearVelocity() {
        const mark = enter();
        try {
            const out = room(12);
            check(M._cairn_body_get_linear_velocity(use(this.world), this.low, this.high, out));
            return fields.getVec3(out);
        } finally {
            leave(mark);
        }
    }

    set linearVelocity(velocity) {
        const mark = enter();
        try {
            const $velocity = room(12);
            fields.putVec3($velocity, velocity, 'velocity');
            check(M._cairn_body_set_linear_velocity(use(this.world), this.low, this.high, $velocity));
        } finally {
            leave(mark);
        }
    }

    get angularVelocity() {
        const mark = enter();
        try {
            const out = room(12);
            check(M._cairn_body_get_angular_velocity(use(this.world), this.low, this.high, out));
            return fields.getVec3(out);
        } finally {
            leave(mark);
        }
    }

    set angularVelocity(velocity) {
        const mark = enter();
        try {
            const $velocity = room(12);
            fields.putVec3($velocity, velocity, 'velocity');
            check(M._cairn_body_set_angular_velocity(use(this.world), this.low, this.high, $velocity));
        } finally {
            leave(mark);
        }
    }

    velocityAt(point) {
        const mark = enter();
        try {
            const $point = room(24);
            fields.putPosition($point, point, 'point');
            const out = room(12);
            check(M._cairn_body_get_velocity_at(use(this.world), this.low, this.high, $point, out));
            return fields.getVec3(out);
        } finally {
            leave(mark);
        }
    }

    get mass() {
        const mark = enter();
        try {
            const out = room(4);
            check(M._cairn_body_get_mass(use(this.world), this.low, this.high, out));
            return fields.getFloat(out);
        } finally {
            leave(mark);
        }
    }

    get massProperties() {
        const mark = enter();
        try {
            const out = room(44);
            check(M._cairn_body_get_mass_properties(use(this.world), this.low, this.high, out));
            return values.getMassProperties(out);
        } finally {
            leave(mark);
        }
    }

    set massProperties(properties) {
        const mark = enter();
        try {
            const $properties = room(44);
            M._cairn_default_mass_properties($properties);
            values.putMassProperties($properties, properties, 'MassProperties');
            check(M._cairn_body_set_mass_properties(use(this.world), this.low, this.high, $properties));
        } finally {
            leave(mark);
        }
    }

    get worldInertia() {
        const mark = enter();
        try {
            const out = room(36);
            check(M._cairn_body_get_world_inertia(use(this.world), this.low, this.high, out));
            return fields.getMat3(out);
        } finally {
            leave(mark);
        }
    }

    get angularMomentum() {
        const mark = enter();
        try {
            const out = room(12);
            check(M._cairn_body_get_angular_momentum(use(this.world), this.low, this.high, out));
            return fields.getVec3(out);
        } finally {
            leave(mark);
        }
    }

    get kineticEnergy() {
        const mark = enter();
        try {
            const out = room(8);
            check(M._cairn_body_get_kinetic_energy(use(this.world), this.low, this.high, out));
            return fields.getDouble(out);
        } finally {
            leave(mark);
        }
    }

    get gravityScale() {
        const mark = enter();
        try {
            const out = room(4);
            check(M._cairn_body_get_gravity_scale(use(this.world), this.low, this.high, out));
            return fields.getFloat(out);
        } finally {
            leave(mark);
        }
    }

    set gravityScale(scale) {
        const mark = enter();
        try {
            const $scale = numberOf(scale, 'scale');
            check(M._cairn_body_set_gravity_scale(use(this.world), this.low, this.high, $scale));
        } finally {
            leave(mark);
        }
    }

    get linearDamping() {
        const mark = enter();
        try {
            const out = room(4);
            check(M._cairn_body_get_linear_damping(use(this.world), this.low, this.high, out));
            return fields.getFloat(out);
        } finally {
            leave(mark);
        }
    }

    get angularDamping() {
        const mark = enter();
        try {
            const out = room(4);
            check(M._cairn_body_get_angular_damping(use(this.world), this.low, this.high, out));
            return fields.getFloat(out);
        } finally {
            leave(mark);
        }
    }

    get isAwake() {
        const mark = enter();
        try {
            const out = room(1);
            check(M._cairn_body_is_awake(use(this.world), this.low, this.high, out));
            return fields.getBool(out);
        } finally {
            leave(mark);
        }
    }

    get allowSleep() {
        const mark = enter();
        try {
            const out = room(1);
            check(M._cairn_body_get_allow_sleep(use(this.world), this.low, this.high, out));
            return fields.getBool(out);
        } finally {
            leave(mark);
        }
    }

    set allowSleep(allow) {
        const mark = enter();
        try {
            const $allow = boolOf(allow, 'allow');
            check(M._cairn_body_set_allow_sleep(use(this.world), this.low, this.high, $allow));
        } finally {
            leave(mark);
        }
    }

    get enabled() {
        const mark = enter();
        try {
            const out = room(1);
            check(M._cairn_body_get_enabled(use(this.world), this.low, this.high, out));
            return fields.getBool(out);
        } finally {
            leave(mark);
        }
    }

    set enabled(enabled) {
        const mark = enter();
        try {
            const $enabled = boolOf(enabled, 'enabled');
            check(M._cairn_body_set_enabled(use(this.world), this.low, this.high, $enabled));
        } finally {
            leave(mark);
        }
    }

    get shapes() {
        const mark = enter();
        try {
            return listOf(8, (list, capacity, count) => M._cairn_body_get_shapes(use(this.world), this.low, this.high, list, capacity, count), (at) => fields.getU64(at));
        } finally {
            leave(mark);
        }
    }

    setTransform(position, rotation) {
        const mark = enter();
        try {
            const $position = room(24);
            fields.putPosition($position, position, 'position');
            const $rotation = room(16);
            fields.putQuat($rotation, rotation, 'rotation');
            check(M._cairn_body_set_transform(use(this.world), this.low, this.high, $position, $rotation));
        } finally {
            leave(mark);
        }
    }

    moveTo(target, seconds) {
        const mark = enter();
        try {
            const $target = room(40);
            M._cairn_default_transform($target);
            values.putTransform($target, target, 'Transform');
            const $seconds = numberOf(seconds, 'seconds');
            check(M._cairn_body_move_to(use(this.world), this.low, this.high, $target, $seconds));
        } finally {
            leave(mark);
        }
    }

    setDamping(linear, angular) {
        const mark = enter();
        try {
            const $linear = numberOf(linear, 'linear');
            const $angular = numberOf(angular, 'angular');
            check(M._cairn_body_set_damping(use(this.world), this.low, this.high, $linear, $angular));
        } finally {
            leave(mark);
        }
    }

    setMassFromShapes(mass) {
        const mark = enter();
        try {
            const $mass = mass === undefined || mass === null ? 0 : placed(4, (at) => fields.putFloat(at, mass, 'mass'));
            check(M._cairn_body_set_mass_from_shapes(use(this.world), this.low, this.high, $mass));
        } finally {
            leave(mark);
        }
    }

    wake() {
        const mark = enter();
        try {
            check(M._cairn_body_wake(use(this.world), this.low, this.high));
        } finally {
            leave(mark);
        }
    }

    sleep() {
        const mark = enter();
        try {
            check(M._cairn_body_sleep(use(this.world), this.low, this.high));
        } finally {
            leave(mark);
        }
    }

    addForce(force) {
        const mark = enter();
        try {
            const $force = room(12);
            fields.putVec3($force, force, 'force');
            check(M._cairn_body_add_force(use(this.world), this.low, this.high, $force));
        } finally {
            leave(mark);
        }
    }

    addForceAt(force, point) {
        const mark = enter();
        try {
            const $force = room(12);
            fields.putVec3($force, force, 'force');
            const $point = room(24);
            fields.putPosition($point, point, 'point');
            check(M._cairn_body_add_force_at(use(this.world), this.low, this.high, $force, $point));
        } finally {
            leave(mark);
        }
    }

    addTorque(torque) {
        const mark = enter();
        try {
            const $torque = room(12);
            fields.putVec3($torque, torque, 'torque');
            check(M._cairn_body_add_torque(use(this.world), this.low, this.high, $torque));
        } finally {
            leave(mark);
        }
    }

    applyImpulse(impulse) {
        const mark = enter();
        try {
            const $impulse = room(12);
            fields.putVec3($impulse, impulse, 'impulse');
            check(M._cairn_body_apply_impulse(use(this.world), this.low, this.high, $impulse));
        } finally {
            leave(mark);
        }
    }

    applyImpulseAt(impulse, point) {
        const mark = enter();
        try {
            const $impulse = room(12);
            fields.putVec3($impulse, impulse, 'impulse');
            const $point = room(24);
            fields.putPosition($point, point, 'point');
            check(M._cairn_body_apply_impulse_at(use(this.world), this.low, this.high, $impulse, $point));
        } finally {
            leave(mark);
        }
    }

    applyAngularImpulse(impulse) {
        const mark = enter();
        try {
            const $impulse = room(12);
            fields.putVec3($impulse, impulse, 'impulse');
            check(M._cairn_body_apply_angular_impulse(use(this.world), this.low, this.high, $impulse));
        } finally {
            leave(mark);
        }
    }

    get isCharacter() {
        const mark = enter();
        try {
            const out = room(1);
            check(M._cairn_body_is_character(use(this.world), this.low, this.high, out));
            return fields.getBool(out);
        } finally {
            leave(mark);
        }
    }

    get character() {
        const mark = enter();
        try {
            const out = room(48);
            M._cairn_default_character_def(out);
            check(M._cairn_body_get_character(use(this.world), this.low, this.high, out));
            return values.getCharacterDef(out);
        } finally {
            leave(mark);
        }
    }

    set character(definition) {
        const mark = enter();
        try {
            const $def = room(48);
            M._cairn_default_character_def($def);
            values.putCharacterDef($def, definition, 'CharacterDef');
            check(M._cairn_body_set_character(use(this.world), this.low, this.high, $def));
        } finally {
            leave(mark);
        }
    }

    removeCharacter() {
        const mark = enter();
        try {
            check(M._cairn_body_remove_character(use(this.world), this.low, this.high));
        } finally {
            leave(mark);
        }
    }

    get walkVelocity() {
        const mark = enter();
        try {
            const out = room(12);
            check(M._cairn_body_get_walk_velocity(use(this.world), this.low, this.high, out));
            return fields.getVec3(out);
        } finally {
            leave(mark);
        }
    }

    set walkVelocity(velocity) {
        const mark = enter();
        try {
            const $velocity = room(12);
            fields.putVec3($velocity, velocity, 'velocity');
            check(M._cairn_body_set_walk_velocity(use(this.world), this.low, this.high, $velocity));
        } finally {
            leave(mark);
        }
    }

    jump(speed) {
        const mark = enter();
        try {
            const $speed = numberOf(speed, 'speed');
            check(M._cairn_body_jump(use(this.world), this.low, this.high, $speed));
        } finally {
            leave(mark);
        }
    }

    get characterState() {
        const mark = enter();
        try {
            const out = room(80);
            check(M._cairn_body_character_state(use(this.world), this.low, this.high, out));
            return values.getCharacterState(out);
        } finally {
            leave(mark);
        }
    }

    get joints() {
        const mark = enter();
        try {
            return listOf(8, (list, capacity, count) => M._cairn_body_get_joints(use(this.world), this.low, this.high, list, capacity, count), (at) => fields.getU64(at));
        } finally {
            leave(mark);
        }
    }

    get contacts() {
        const mark = enter();
        try {
            return listOf(200, (list, capacity, count) => M._cairn_body_get_contacts(use(this.world), this.low, this.high, list, capacity, count), (at) => values.getContact(at));
        } finally {
            leave(mark);
        }
    }
}
