// Made by tools/api.py from api/: change those, and run it.
// How the structs of the API lie in the memory of the module.
import { M, objectOf, keysOf, indexOf, unknown } from '../memory.js';
import {
    getBool,
    getDVec3,
    getDouble,
    getFloat,
    getGeometry,
    getInt,
    getList,
    getMany,
    getMat3,
    getPosition,
    getQuat,
    getSize,
    getString,
    getU32,
    getU64,
    getVec2,
    getVec3,
    putBool,
    putDVec3,
    putDouble,
    putEnum,
    putFloat,
    putGeometry,
    putHandle,
    putInt,
    putList,
    putMany,
    putPosition,
    putQuat,
    putSize,
    putString,
    putU32,
    putU64,
    putVec2,
    putVec3,
} from '../fields.js';

export const COMBINE_RULE = ['average', 'minimum', 'maximum', 'multiply'];

export const BODY_TYPE = ['static', 'kinematic', 'dynamic'];

export const CHARACTER_SUPPORT = ['none', 'steep', 'ground'];

export const JOINT_AXIS = ['linear', 'angular'];

export const JOINT_SOLVER = ['automatic', 'iterative', 'direct'];

export const BROAD_PHASE_TREE = ['fixed', 'awake', 'large', 'sleeping'];

export const INTEGRATOR = ['semiImplicitEuler', 'explicitEuler', 'rk4'];

export const FORCE_FIELD_KIND = ['uniform', 'radial', 'fluid'];

export function putTransform(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'position': putPosition(p, x, 'Transform.position'); break;
        case 'rotation': putQuat(p + 24, x, 'Transform.rotation'); break;
        default: unknown('Transform', key, ['position', 'rotation']);
        }
    }
}

export function getTransform(p) {
    return {
        position: getPosition(p),
        rotation: getQuat(p + 24),
    };
}

export function putBounds(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'min': putPosition(p, x, 'Bounds.min'); break;
        case 'max': putPosition(p + 24, x, 'Bounds.max'); break;
        default: unknown('Bounds', key, ['min', 'max']);
        }
    }
}

export function getBounds(p) {
    return {
        min: getPosition(p),
        max: getPosition(p + 24),
    };
}

export function putSphere(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'radius': putFloat(p, x, 'Sphere.radius'); break;
        default: unknown('Sphere', key, ['radius']);
        }
    }
}

export function getSphere(p) {
    return {
        radius: getFloat(p),
    };
}

export function putBox(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'halfExtents': putVec3(p, x, 'Box.halfExtents'); break;
        case 'rounding': putFloat(p + 12, x, 'Box.rounding'); break;
        default: unknown('Box', key, ['halfExtents', 'rounding']);
        }
    }
}

export function getBox(p) {
    return {
        halfExtents: getVec3(p),
        rounding: getFloat(p + 12),
    };
}

export function putPlane(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'normal': putVec3(p, x, 'Plane.normal'); break;
        case 'tangent': putVec3(p + 12, x, 'Plane.tangent'); break;
        case 'halfExtents': if (x === null) continue; putVec2(p + 28, x, 'Plane.halfExtents'); putBool(p + 24, true, 'Plane.halfExtents'); break;
        case 'doubleSided': putBool(p + 36, x, 'Plane.doubleSided'); break;
        default: unknown('Plane', key, ['normal', 'tangent', 'halfExtents', 'doubleSided']);
        }
    }
}

export function getPlane(p) {
    return {
        normal: getVec3(p),
        tangent: getVec3(p + 12),
        halfExtents: getBool(p + 24) ? getVec2(p + 28) : null,
        doubleSided: getBool(p + 36),
    };
}

export function putCapsule(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'halfHeight': putFloat(p, x, 'Capsule.halfHeight'); break;
        case 'radius': putFloat(p + 4, x, 'Capsule.radius'); break;
        case 'radiusTop': if (x === null) continue; putFloat(p + 12, x, 'Capsule.radiusTop'); putBool(p + 8, true, 'Capsule.radiusTop'); break;
        default: unknown('Capsule', key, ['halfHeight', 'radius', 'radiusTop']);
        }
    }
}

export function getCapsule(p) {
    return {
        halfHeight: getFloat(p),
        radius: getFloat(p + 4),
        radiusTop: getBool(p + 8) ? getFloat(p + 12) : null,
    };
}

export function putCylinder(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'halfHeight': putFloat(p, x, 'Cylinder.halfHeight'); break;
        case 'radius': putFloat(p + 4, x, 'Cylinder.radius'); break;
        case 'radiusTop': if (x === null) continue; putFloat(p + 12, x, 'Cylinder.radiusTop'); putBool(p + 8, true, 'Cylinder.radiusTop'); break;
        case 'rounding': putFloat(p + 16, x, 'Cylinder.rounding'); break;
        default: unknown('Cylinder', key, ['halfHeight', 'radius', 'radiusTop', 'rounding']);
        }
    }
}

export function getCylinder(p) {
    return {
        halfHeight: getFloat(p),
        radius: getFloat(p + 4),
        radiusTop: getBool(p + 8) ? getFloat(p + 12) : null,
        rounding: getFloat(p + 16),
    };
}

export function putHull(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'geometry': putGeometry(p, x, 'Hull.geometry'); break;
        case 'rounding': putFloat(p + 4, x, 'Hull.rounding'); break;
        default: unknown('Hull', key, ['geometry', 'rounding']);
        }
    }
}

export function getHull(p) {
    return {
        geometry: getGeometry(p),
        rounding: getFloat(p + 4),
    };
}

export function putMesh(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'geometry': putGeometry(p, x, 'Mesh.geometry'); break;
        default: unknown('Mesh', key, ['geometry']);
        }
    }
}

export function getMesh(p) {
    return {
        geometry: getGeometry(p),
    };
}

export function putHeightField(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'geometry': putGeometry(p, x, 'HeightField.geometry'); break;
        default: unknown('HeightField', key, ['geometry']);
        }
    }
}

export function getHeightField(p) {
    return {
        geometry: getGeometry(p),
    };
}

export function putMaterial(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'staticFriction': putFloat(p, x, 'Material.staticFriction'); break;
        case 'dynamicFriction': putFloat(p + 4, x, 'Material.dynamicFriction'); break;
        case 'restitution': putFloat(p + 8, x, 'Material.restitution'); break;
        case 'rollingFriction': putFloat(p + 12, x, 'Material.rollingFriction'); break;
        case 'torsionalFriction': putFloat(p + 16, x, 'Material.torsionalFriction'); break;
        case 'frictionCombine': putEnum(p + 20, x, COMBINE_RULE, 'Material.frictionCombine'); break;
        case 'restitutionCombine': putEnum(p + 24, x, COMBINE_RULE, 'Material.restitutionCombine'); break;
        default: unknown('Material', key, ['staticFriction', 'dynamicFriction', 'restitution', 'rollingFriction', 'torsionalFriction', 'frictionCombine', 'restitutionCombine']);
        }
    }
}

export function getMaterial(p) {
    return {
        staticFriction: getFloat(p),
        dynamicFriction: getFloat(p + 4),
        restitution: getFloat(p + 8),
        rollingFriction: getFloat(p + 12),
        torsionalFriction: getFloat(p + 16),
        frictionCombine: COMBINE_RULE[getInt(p + 20)],
        restitutionCombine: COMBINE_RULE[getInt(p + 24)],
    };
}

export function putCollisionFilter(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'layers': putU64(p, x, 'CollisionFilter.layers'); break;
        case 'collidesWith': putU64(p + 8, x, 'CollisionFilter.collidesWith'); break;
        default: unknown('CollisionFilter', key, ['layers', 'collidesWith']);
        }
    }
}

export function getCollisionFilter(p) {
    return {
        layers: getU64(p),
        collidesWith: getU64(p + 8),
    };
}

export function putShapeDef(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'position': putVec3(p + 4, x, 'ShapeDef.position'); break;
        case 'rotation': putQuat(p + 16, x, 'ShapeDef.rotation'); break;
        case 'density': putFloat(p + 32, x, 'ShapeDef.density'); break;
        case 'material': putMaterial(p + 36, x, 'ShapeDef.material'); break;
        case 'filter': putCollisionFilter(p + 64, x, 'ShapeDef.filter'); break;
        case 'isTrigger': putBool(p + 80, x, 'ShapeDef.isTrigger'); break;
        case 'surfaceVelocity': putVec3(p + 84, x, 'ShapeDef.surfaceVelocity'); break;
        case 'userData': putU64(p + 96, x, 'ShapeDef.userData'); break;
        case 'oneWay': putVec3(p + 104, x, 'ShapeDef.oneWay'); break;
        default: unknown('ShapeDef', key, ['position', 'rotation', 'density', 'material', 'filter', 'isTrigger', 'surfaceVelocity', 'userData', 'oneWay']);
        }
    }
}

export function getShapeDef(p) {
    return {
        position: getVec3(p + 4),
        rotation: getQuat(p + 16),
        density: getFloat(p + 32),
        material: getMaterial(p + 36),
        filter: getCollisionFilter(p + 64),
        isTrigger: getBool(p + 80),
        surfaceVelocity: getVec3(p + 84),
        userData: getU64(p + 96),
        oneWay: getVec3(p + 104),
    };
}

export function putMassProperties(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'mass': putFloat(p, x, 'MassProperties.mass'); break;
        case 'centerOfMass': putVec3(p + 4, x, 'MassProperties.centerOfMass'); break;
        case 'inertiaDiagonal': putVec3(p + 16, x, 'MassProperties.inertiaDiagonal'); break;
        case 'inertiaOrientation': putQuat(p + 28, x, 'MassProperties.inertiaOrientation'); break;
        default: unknown('MassProperties', key, ['mass', 'centerOfMass', 'inertiaDiagonal', 'inertiaOrientation']);
        }
    }
}

export function getMassProperties(p) {
    return {
        mass: getFloat(p),
        centerOfMass: getVec3(p + 4),
        inertiaDiagonal: getVec3(p + 16),
        inertiaOrientation: getQuat(p + 28),
    };
}

export function putBodyDef(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'type': putEnum(p + 4, x, BODY_TYPE, 'BodyDef.type'); break;
        case 'position': putPosition(p + 8, x, 'BodyDef.position'); break;
        case 'rotation': putQuat(p + 32, x, 'BodyDef.rotation'); break;
        case 'linearVelocity': putVec3(p + 48, x, 'BodyDef.linearVelocity'); break;
        case 'angularVelocity': putVec3(p + 60, x, 'BodyDef.angularVelocity'); break;
        case 'linearDamping': putFloat(p + 72, x, 'BodyDef.linearDamping'); break;
        case 'angularDamping': putFloat(p + 76, x, 'BodyDef.angularDamping'); break;
        case 'gravityScale': putFloat(p + 80, x, 'BodyDef.gravityScale'); break;
        case 'allowSleep': putBool(p + 84, x, 'BodyDef.allowSleep'); break;
        case 'mass': if (x === null) continue; putFloat(p + 88, x, 'BodyDef.mass'); putBool(p + 85, true, 'BodyDef.mass'); break;
        case 'massProperties': if (x === null) continue; M._cairn_default_mass_properties(p + 96); putMassProperties(p + 96, x, 'BodyDef.massProperties'); putBool(p + 92, true, 'BodyDef.massProperties'); break;
        case 'name': putString(p + 140, x, 'BodyDef.name'); break;
        case 'userData': putU64(p + 144, x, 'BodyDef.userData'); break;
        case 'enabled': putBool(p + 152, x, 'BodyDef.enabled'); break;
        default: unknown('BodyDef', key, ['type', 'position', 'rotation', 'linearVelocity', 'angularVelocity', 'linearDamping', 'angularDamping', 'gravityScale', 'allowSleep', 'mass', 'massProperties', 'name', 'userData', 'enabled']);
        }
    }
}

export function getBodyDef(p) {
    return {
        type: BODY_TYPE[getInt(p + 4)],
        position: getPosition(p + 8),
        rotation: getQuat(p + 32),
        linearVelocity: getVec3(p + 48),
        angularVelocity: getVec3(p + 60),
        linearDamping: getFloat(p + 72),
        angularDamping: getFloat(p + 76),
        gravityScale: getFloat(p + 80),
        allowSleep: getBool(p + 84),
        mass: getBool(p + 85) ? getFloat(p + 88) : null,
        massProperties: getBool(p + 92) ? getMassProperties(p + 96) : null,
        name: getString(p + 140),
        userData: getU64(p + 144),
        enabled: getBool(p + 152),
    };
}

export function putCharacterDef(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'up': putVec3(p + 4, x, 'CharacterDef.up'); break;
        case 'maxSlope': putFloat(p + 16, x, 'CharacterDef.maxSlope'); break;
        case 'stepHeight': putFloat(p + 20, x, 'CharacterDef.stepHeight'); break;
        case 'stickDistance': putFloat(p + 24, x, 'CharacterDef.stickDistance'); break;
        case 'skin': putFloat(p + 28, x, 'CharacterDef.skin'); break;
        case 'mass': putFloat(p + 32, x, 'CharacterDef.mass'); break;
        case 'maxPushForce': putFloat(p + 36, x, 'CharacterDef.maxPushForce'); break;
        case 'airAcceleration': putFloat(p + 40, x, 'CharacterDef.airAcceleration'); break;
        case 'flies': putBool(p + 44, x, 'CharacterDef.flies'); break;
        default: unknown('CharacterDef', key, ['up', 'maxSlope', 'stepHeight', 'stickDistance', 'skin', 'mass', 'maxPushForce', 'airAcceleration', 'flies']);
        }
    }
}

export function getCharacterDef(p) {
    return {
        up: getVec3(p + 4),
        maxSlope: getFloat(p + 16),
        stepHeight: getFloat(p + 20),
        stickDistance: getFloat(p + 24),
        skin: getFloat(p + 28),
        mass: getFloat(p + 32),
        maxPushForce: getFloat(p + 36),
        airAcceleration: getFloat(p + 40),
        flies: getBool(p + 44),
    };
}

export function getCharacterState(p) {
    return {
        support: CHARACTER_SUPPORT[getInt(p)],
        velocity: getVec3(p + 4),
        groundShape: getU64(p + 16),
        groundBody: getU64(p + 24),
        groundPoint: getPosition(p + 32),
        groundNormal: getVec3(p + 56),
        groundVelocity: getVec3(p + 68),
    };
}

export function putJointSpring(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'stiffness': putFloat(p, x, 'JointSpring.stiffness'); break;
        case 'damping': putFloat(p + 4, x, 'JointSpring.damping'); break;
        case 'isAcceleration': putBool(p + 8, x, 'JointSpring.isAcceleration'); break;
        default: unknown('JointSpring', key, ['stiffness', 'damping', 'isAcceleration']);
        }
    }
}

export function getJointSpring(p) {
    return {
        stiffness: getFloat(p),
        damping: getFloat(p + 4),
        isAcceleration: getBool(p + 8),
    };
}

export function putJointRange(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'lower': putFloat(p, x, 'JointRange.lower'); break;
        case 'upper': putFloat(p + 4, x, 'JointRange.upper'); break;
        case 'spring': if (x === null) continue; M._cairn_default_joint_spring(p + 12); putJointSpring(p + 12, x, 'JointRange.spring'); putBool(p + 8, true, 'JointRange.spring'); break;
        default: unknown('JointRange', key, ['lower', 'upper', 'spring']);
        }
    }
}

export function getJointRange(p) {
    return {
        lower: getFloat(p),
        upper: getFloat(p + 4),
        spring: getBool(p + 8) ? getJointSpring(p + 12) : null,
    };
}

export function putJointMotor(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'velocity': putFloat(p, x, 'JointMotor.velocity'); break;
        case 'position': putFloat(p + 4, x, 'JointMotor.position'); break;
        case 'spring': if (x === null) continue; M._cairn_default_joint_spring(p + 12); putJointSpring(p + 12, x, 'JointMotor.spring'); putBool(p + 8, true, 'JointMotor.spring'); break;
        case 'maxForce': putFloat(p + 24, x, 'JointMotor.maxForce'); break;
        default: unknown('JointMotor', key, ['velocity', 'position', 'spring', 'maxForce']);
        }
    }
}

export function getJointMotor(p) {
    return {
        velocity: getFloat(p),
        position: getFloat(p + 4),
        spring: getBool(p + 8) ? getJointSpring(p + 12) : null,
        maxForce: getFloat(p + 24),
    };
}

export function putJointControl(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'limits': if (x === null) continue; M._cairn_default_joint_range(p + 4); putJointRange(p + 4, x, 'JointControl.limits'); putBool(p, true, 'JointControl.limits'); break;
        case 'motor': if (x === null) continue; M._cairn_default_joint_motor(p + 32); putJointMotor(p + 32, x, 'JointControl.motor'); putBool(p + 28, true, 'JointControl.motor'); break;
        case 'friction': putFloat(p + 60, x, 'JointControl.friction'); break;
        default: unknown('JointControl', key, ['limits', 'motor', 'friction']);
        }
    }
}

export function getJointControl(p) {
    return {
        limits: getBool(p) ? getJointRange(p + 4) : null,
        motor: getBool(p + 28) ? getJointMotor(p + 32) : null,
        friction: getFloat(p + 60),
    };
}

export function putFixedJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        default: unknown('FixedJoint', key, []);
        }
    }
}

export function getFixedJoint() {
    return {};
}

export function putBallJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'coneAngle': if (x === null) continue; putFloat(p + 4, x, 'BallJoint.coneAngle'); putBool(p, true, 'BallJoint.coneAngle'); break;
        case 'twist': if (x === null) continue; M._cairn_default_joint_range(p + 12); putJointRange(p + 12, x, 'BallJoint.twist'); putBool(p + 8, true, 'BallJoint.twist'); break;
        case 'friction': putFloat(p + 36, x, 'BallJoint.friction'); break;
        default: unknown('BallJoint', key, ['coneAngle', 'twist', 'friction']);
        }
    }
}

export function getBallJoint(p) {
    return {
        coneAngle: getBool(p) ? getFloat(p + 4) : null,
        twist: getBool(p + 8) ? getJointRange(p + 12) : null,
        friction: getFloat(p + 36),
    };
}

export function putHingeJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'angle': putJointControl(p, x, 'HingeJoint.angle'); break;
        default: unknown('HingeJoint', key, ['angle']);
        }
    }
}

export function getHingeJoint(p) {
    return {
        angle: getJointControl(p),
    };
}

export function putSliderJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'translation': putJointControl(p, x, 'SliderJoint.translation'); break;
        default: unknown('SliderJoint', key, ['translation']);
        }
    }
}

export function getSliderJoint(p) {
    return {
        translation: getJointControl(p),
    };
}

export function putCylindricalJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'translation': putJointControl(p, x, 'CylindricalJoint.translation'); break;
        case 'angle': putJointControl(p + 64, x, 'CylindricalJoint.angle'); break;
        default: unknown('CylindricalJoint', key, ['translation', 'angle']);
        }
    }
}

export function getCylindricalJoint(p) {
    return {
        translation: getJointControl(p),
        angle: getJointControl(p + 64),
    };
}

export function putUniversalJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'first': putJointControl(p, x, 'UniversalJoint.first'); break;
        case 'second': putJointControl(p + 64, x, 'UniversalJoint.second'); break;
        default: unknown('UniversalJoint', key, ['first', 'second']);
        }
    }
}

export function getUniversalJoint(p) {
    return {
        first: getJointControl(p),
        second: getJointControl(p + 64),
    };
}

export function putDistanceJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'distance': putJointControl(p, x, 'DistanceJoint.distance'); break;
        default: unknown('DistanceJoint', key, ['distance']);
        }
    }
}

export function getDistanceJoint(p) {
    return {
        distance: getJointControl(p),
    };
}

export function putWheelJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'suspension': putJointControl(p, x, 'WheelJoint.suspension'); break;
        case 'steering': if (x === null) continue; M._cairn_default_joint_control(p + 68); putJointControl(p + 68, x, 'WheelJoint.steering'); putBool(p + 64, true, 'WheelJoint.steering'); break;
        case 'spin': putJointControl(p + 132, x, 'WheelJoint.spin'); break;
        default: unknown('WheelJoint', key, ['suspension', 'steering', 'spin']);
        }
    }
}

export function getWheelJoint(p) {
    return {
        suspension: getJointControl(p),
        steering: getBool(p + 64) ? getJointControl(p + 68) : null,
        spin: getJointControl(p + 132),
    };
}

export function putServoJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'position': putVec3(p, x, 'ServoJoint.position'); break;
        case 'rotation': putQuat(p + 12, x, 'ServoJoint.rotation'); break;
        case 'linear': putJointSpring(p + 28, x, 'ServoJoint.linear'); break;
        case 'angular': putJointSpring(p + 40, x, 'ServoJoint.angular'); break;
        case 'maxForce': putFloat(p + 52, x, 'ServoJoint.maxForce'); break;
        case 'maxTorque': putFloat(p + 56, x, 'ServoJoint.maxTorque'); break;
        default: unknown('ServoJoint', key, ['position', 'rotation', 'linear', 'angular', 'maxForce', 'maxTorque']);
        }
    }
}

export function getServoJoint(p) {
    return {
        position: getVec3(p),
        rotation: getQuat(p + 12),
        linear: getJointSpring(p + 28),
        angular: getJointSpring(p + 40),
        maxForce: getFloat(p + 52),
        maxTorque: getFloat(p + 56),
    };
}

export function putGearJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'ratio': putFloat(p, x, 'GearJoint.ratio'); break;
        default: unknown('GearJoint', key, ['ratio']);
        }
    }
}

export function getGearJoint(p) {
    return {
        ratio: getFloat(p),
    };
}

export function putRackJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'radius': putFloat(p, x, 'RackJoint.radius'); break;
        default: unknown('RackJoint', key, ['radius']);
        }
    }
}

export function getRackJoint(p) {
    return {
        radius: getFloat(p),
    };
}

export function putPulleyJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'groundA': putPosition(p, x, 'PulleyJoint.groundA'); break;
        case 'groundB': putPosition(p + 24, x, 'PulleyJoint.groundB'); break;
        case 'ratio': putFloat(p + 48, x, 'PulleyJoint.ratio'); break;
        case 'length': if (x === null) continue; putFloat(p + 56, x, 'PulleyJoint.length'); putBool(p + 52, true, 'PulleyJoint.length'); break;
        default: unknown('PulleyJoint', key, ['groundA', 'groundB', 'ratio', 'length']);
        }
    }
}

export function getPulleyJoint(p) {
    return {
        groundA: getPosition(p),
        groundB: getPosition(p + 24),
        ratio: getFloat(p + 48),
        length: getBool(p + 52) ? getFloat(p + 56) : null,
    };
}

export function putJointLimit(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'kind': putEnum(p, x, JOINT_AXIS, 'JointLimit.kind'); break;
        case 'axes': putMany(p + 4, x, 3, 'JointLimit.axes', (at, x, i, place) => { putBool(at + 1 * i, x, place); }); break;
        case 'min': if (x === null) continue; putFloat(p + 8, x, 'JointLimit.min'); putBool(p + 7, true, 'JointLimit.min'); break;
        case 'max': if (x === null) continue; putFloat(p + 16, x, 'JointLimit.max'); putBool(p + 12, true, 'JointLimit.max'); break;
        case 'stiffness': if (x === null) continue; putFloat(p + 24, x, 'JointLimit.stiffness'); putBool(p + 20, true, 'JointLimit.stiffness'); break;
        case 'damping': putFloat(p + 28, x, 'JointLimit.damping'); break;
        default: unknown('JointLimit', key, ['kind', 'axes', 'min', 'max', 'stiffness', 'damping']);
        }
    }
}

export function getJointLimit(p) {
    return {
        kind: JOINT_AXIS[getInt(p)],
        axes: getMany(p + 4, 3, 1, (at) => getBool(at)),
        min: getBool(p + 7) ? getFloat(p + 8) : null,
        max: getBool(p + 12) ? getFloat(p + 16) : null,
        stiffness: getBool(p + 20) ? getFloat(p + 24) : null,
        damping: getFloat(p + 28),
    };
}

export function putJointDrive(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'kind': putEnum(p, x, JOINT_AXIS, 'JointDrive.kind'); break;
        case 'isAcceleration': putBool(p + 4, x, 'JointDrive.isAcceleration'); break;
        case 'axis': putInt(p + 8, x, 'JointDrive.axis'); break;
        case 'maxForce': if (x === null) continue; putFloat(p + 16, x, 'JointDrive.maxForce'); putBool(p + 12, true, 'JointDrive.maxForce'); break;
        case 'positionTarget': putFloat(p + 20, x, 'JointDrive.positionTarget'); break;
        case 'velocityTarget': putFloat(p + 24, x, 'JointDrive.velocityTarget'); break;
        case 'stiffness': putFloat(p + 28, x, 'JointDrive.stiffness'); break;
        case 'damping': putFloat(p + 32, x, 'JointDrive.damping'); break;
        default: unknown('JointDrive', key, ['kind', 'isAcceleration', 'axis', 'maxForce', 'positionTarget', 'velocityTarget', 'stiffness', 'damping']);
        }
    }
}

export function getJointDrive(p) {
    return {
        kind: JOINT_AXIS[getInt(p)],
        isAcceleration: getBool(p + 4),
        axis: getInt(p + 8),
        maxForce: getBool(p + 12) ? getFloat(p + 16) : null,
        positionTarget: getFloat(p + 20),
        velocityTarget: getFloat(p + 24),
        stiffness: getFloat(p + 28),
        damping: getFloat(p + 32),
    };
}

export function putGeneralJoint(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'limits': putList(p, p + 4, x, 32, 'GeneralJoint.limits', (at, x, place) => { M._cairn_default_joint_limit(at); putJointLimit(at, x, place); }); break;
        case 'drives': putList(p + 8, p + 12, x, 36, 'GeneralJoint.drives', (at, x, place) => { M._cairn_default_joint_drive(at); putJointDrive(at, x, place); }); break;
        default: unknown('GeneralJoint', key, ['limits', 'drives']);
        }
    }
}

export function getGeneralJoint(p) {
    return {
        limits: getList(p, p + 4, 32, (at) => getJointLimit(at)),
        drives: getList(p + 8, p + 12, 36, (at) => getJointDrive(at)),
    };
}

export function putJointDef(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'bodyA': putHandle(p + 8, x, 'JointDef.bodyA'); break;
        case 'bodyB': putHandle(p + 16, x, 'JointDef.bodyB'); break;
        case 'frameA': putTransform(p + 24, x, 'JointDef.frameA'); break;
        case 'frameB': putTransform(p + 64, x, 'JointDef.frameB'); break;
        case 'joint': putJoint(p + 104, x, 'JointDef.joint'); break;
        case 'enableCollision': putBool(p + 624, x, 'JointDef.enableCollision'); break;
        case 'breakForce': putFloat(p + 628, x, 'JointDef.breakForce'); break;
        case 'breakTorque': putFloat(p + 632, x, 'JointDef.breakTorque'); break;
        case 'solver': putEnum(p + 636, x, JOINT_SOLVER, 'JointDef.solver'); break;
        case 'name': putString(p + 640, x, 'JointDef.name'); break;
        case 'userData': putU64(p + 648, x, 'JointDef.userData'); break;
        case 'enabled': putBool(p + 656, x, 'JointDef.enabled'); break;
        default: unknown('JointDef', key, ['bodyA', 'bodyB', 'frameA', 'frameB', 'joint', 'enableCollision', 'breakForce', 'breakTorque', 'solver', 'name', 'userData', 'enabled']);
        }
    }
}

export function getJointDef(p) {
    return {
        bodyA: getU64(p + 8),
        bodyB: getU64(p + 16),
        frameA: getTransform(p + 24),
        frameB: getTransform(p + 64),
        joint: getJoint(p + 104),
        enableCollision: getBool(p + 624),
        breakForce: getFloat(p + 628),
        breakTorque: getFloat(p + 632),
        solver: JOINT_SOLVER[getInt(p + 636)],
        name: getString(p + 640),
        userData: getU64(p + 648),
        enabled: getBool(p + 656),
    };
}

export function getJointState(p) {
    return {
        force: getVec3(p),
        torque: getVec3(p + 12),
        positions: getMany(p + 24, getInt(p + 56), 4, (at) => getFloat(at)),
        positionCount: getInt(p + 56),
        linearError: getFloat(p + 60),
        angularError: getFloat(p + 64),
    };
}

export function getRayHit(p) {
    return {
        shape: getU64(p),
        body: getU64(p + 8),
        point: getPosition(p + 16),
        normal: getVec3(p + 40),
        distance: getDouble(p + 56),
        triangle: getInt(p + 64),
    };
}

export function getShapeCastHit(p) {
    return {
        shape: getU64(p),
        body: getU64(p + 8),
        fraction: getDouble(p + 16),
        point: getPosition(p + 24),
        normal: getVec3(p + 48),
        triangle: getInt(p + 60),
    };
}

export function getClosestPoint(p) {
    return {
        shape: getU64(p),
        body: getU64(p + 8),
        point: getPosition(p + 16),
        distance: getDouble(p + 40),
        triangle: getInt(p + 48),
    };
}

export function getBroadPhaseNode(p) {
    return {
        bounds: getBounds(p),
        tree: BROAD_PHASE_TREE[getInt(p + 48)],
        depth: getInt(p + 52),
        parent: getInt(p + 56),
        isLeaf: getBool(p + 60),
        shape: getU64(p + 64),
    };
}

export function getSolverContact(p) {
    return {
        shapeA: getU64(p),
        shapeB: getU64(p + 8),
        bodyA: getU64(p + 16),
        bodyB: getU64(p + 24),
        color: getInt(p + 32),
        substeps: getInt(p + 36),
    };
}

export function putDebugLinesDef(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'shapes': putBool(p + 4, x, 'DebugLinesDef.shapes'); break;
        case 'bounds': putBool(p + 5, x, 'DebugLinesDef.bounds'); break;
        case 'centers': putBool(p + 6, x, 'DebugLinesDef.centers'); break;
        case 'velocities': putBool(p + 7, x, 'DebugLinesDef.velocities'); break;
        case 'contacts': putBool(p + 8, x, 'DebugLinesDef.contacts'); break;
        case 'joints': putBool(p + 9, x, 'DebugLinesDef.joints'); break;
        case 'size': putFloat(p + 12, x, 'DebugLinesDef.size'); break;
        case 'impulseScale': putFloat(p + 16, x, 'DebugLinesDef.impulseScale'); break;
        default: unknown('DebugLinesDef', key, ['shapes', 'bounds', 'centers', 'velocities', 'contacts', 'joints', 'size', 'impulseScale']);
        }
    }
}

export function getDebugLinesDef(p) {
    return {
        shapes: getBool(p + 4),
        bounds: getBool(p + 5),
        centers: getBool(p + 6),
        velocities: getBool(p + 7),
        contacts: getBool(p + 8),
        joints: getBool(p + 9),
        size: getFloat(p + 12),
        impulseScale: getFloat(p + 16),
    };
}

export function getDebugLine(p) {
    return {
        begin: getPosition(p),
        end: getPosition(p + 24),
        color: getVec3(p + 48),
    };
}

export function putQueryFilter(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'layers': putU64(p + 8, x, 'QueryFilter.layers'); break;
        case 'ownLayers': putU64(p + 16, x, 'QueryFilter.ownLayers'); break;
        case 'staticBodies': putBool(p + 24, x, 'QueryFilter.staticBodies'); break;
        case 'kinematicBodies': putBool(p + 25, x, 'QueryFilter.kinematicBodies'); break;
        case 'dynamicBodies': putBool(p + 26, x, 'QueryFilter.dynamicBodies'); break;
        case 'triggers': putBool(p + 27, x, 'QueryFilter.triggers'); break;
        case 'any': putBool(p + 28, x, 'QueryFilter.any'); break;
        case 'ignoredBodies': putList(p + 32, p + 36, x, 8, 'QueryFilter.ignoredBodies', (at, x, place) => { putHandle(at, x, place); }); break;
        default: unknown('QueryFilter', key, ['layers', 'ownLayers', 'staticBodies', 'kinematicBodies', 'dynamicBodies', 'triggers', 'any', 'ignoredBodies']);
        }
    }
}

export function getQueryFilter(p) {
    return {
        layers: getU64(p + 8),
        ownLayers: getU64(p + 16),
        staticBodies: getBool(p + 24),
        kinematicBodies: getBool(p + 25),
        dynamicBodies: getBool(p + 26),
        triggers: getBool(p + 27),
        any: getBool(p + 28),
        ignoredBodies: getList(p + 32, p + 36, 8, (at) => getU64(at)),
    };
}

export function getContactBegin(p) {
    return {
        shapeA: getU64(p),
        shapeB: getU64(p + 8),
        bodyA: getU64(p + 16),
        bodyB: getU64(p + 24),
    };
}

export function getContactEnd(p) {
    return {
        shapeA: getU64(p),
        shapeB: getU64(p + 8),
        bodyA: getU64(p + 16),
        bodyB: getU64(p + 24),
    };
}

export function getContactHit(p) {
    return {
        shapeA: getU64(p),
        shapeB: getU64(p + 8),
        bodyA: getU64(p + 16),
        bodyB: getU64(p + 24),
        point: getPosition(p + 32),
        normal: getVec3(p + 56),
        approachSpeed: getFloat(p + 68),
        time: getFloat(p + 72),
        surfaceMaterial: getInt(p + 76),
    };
}

export function getTriggerEvent(p) {
    return {
        trigger: getU64(p),
        other: getU64(p + 8),
        triggerBody: getU64(p + 16),
        otherBody: getU64(p + 24),
        inside: getBool(p + 32),
        time: getFloat(p + 36),
    };
}

export function getJointEvent(p) {
    return {
        joint: getU64(p),
        bodyA: getU64(p + 8),
        bodyB: getU64(p + 16),
        broke: getBool(p + 24),
        force: getFloat(p + 28),
        torque: getFloat(p + 32),
        userData: getU64(p + 40),
    };
}

export function getSleepEvent(p) {
    return {
        body: getU64(p),
        asleep: getBool(p + 8),
    };
}

export function getContactPoint(p) {
    return {
        point: getPosition(p),
        separation: getFloat(p + 24),
        normalImpulse: getFloat(p + 28),
    };
}

export function getContact(p) {
    return {
        shapeA: getU64(p),
        shapeB: getU64(p + 8),
        bodyA: getU64(p + 16),
        bodyB: getU64(p + 24),
        normal: getVec3(p + 32),
        frictionImpulse: getVec3(p + 44),
        pointCount: getInt(p + 56),
        points: getMany(p + 64, getInt(p + 56), 32, (at) => getContactPoint(at)),
        surfaceMaterial: getInt(p + 192),
    };
}

export function putWorldDef(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'gravity': putVec3(p + 4, x, 'WorldDef.gravity'); break;
        case 'substeps': putInt(p + 16, x, 'WorldDef.substeps'); break;
        case 'adaptiveSubsteps': putBool(p + 20, x, 'WorldDef.adaptiveSubsteps'); break;
        case 'integrator': putEnum(p + 24, x, INTEGRATOR, 'WorldDef.integrator'); break;
        case 'enableSleep': putBool(p + 28, x, 'WorldDef.enableSleep'); break;
        case 'sleepSpeed': putFloat(p + 32, x, 'WorldDef.sleepSpeed'); break;
        case 'sleepTime': putFloat(p + 36, x, 'WorldDef.sleepTime'); break;
        case 'restitutionSpeed': putFloat(p + 40, x, 'WorldDef.restitutionSpeed'); break;
        case 'hitSpeed': putFloat(p + 44, x, 'WorldDef.hitSpeed'); break;
        case 'recoverySpeed': putFloat(p + 48, x, 'WorldDef.recoverySpeed'); break;
        case 'maxLinearSpeed': putFloat(p + 52, x, 'WorldDef.maxLinearSpeed'); break;
        case 'maxAngularSpeed': putFloat(p + 56, x, 'WorldDef.maxAngularSpeed'); break;
        default: unknown('WorldDef', key, ['gravity', 'substeps', 'adaptiveSubsteps', 'integrator', 'enableSleep', 'sleepSpeed', 'sleepTime', 'restitutionSpeed', 'hitSpeed', 'recoverySpeed', 'maxLinearSpeed', 'maxAngularSpeed']);
        }
    }
}

export function getWorldDef(p) {
    return {
        gravity: getVec3(p + 4),
        substeps: getInt(p + 16),
        adaptiveSubsteps: getBool(p + 20),
        integrator: INTEGRATOR[getInt(p + 24)],
        enableSleep: getBool(p + 28),
        sleepSpeed: getFloat(p + 32),
        sleepTime: getFloat(p + 36),
        restitutionSpeed: getFloat(p + 40),
        hitSpeed: getFloat(p + 44),
        recoverySpeed: getFloat(p + 48),
        maxLinearSpeed: getFloat(p + 52),
        maxAngularSpeed: getFloat(p + 56),
    };
}

export function putForceField(p, value, where) {
    for (const key of keysOf(value, where)) {
        const x = value[key];
        if (x === undefined) continue;
        switch (key) {
        case 'kind': putEnum(p + 4, x, FORCE_FIELD_KIND, 'ForceField.kind'); break;
        case 'direction': putVec3(p + 8, x, 'ForceField.direction'); break;
        case 'center': putPosition(p + 24, x, 'ForceField.center'); break;
        case 'strength': putFloat(p + 48, x, 'ForceField.strength'); break;
        case 'exponent': putFloat(p + 52, x, 'ForceField.exponent'); break;
        case 'isForce': putBool(p + 56, x, 'ForceField.isForce'); break;
        case 'halfExtents': putVec3(p + 60, x, 'ForceField.halfExtents'); break;
        case 'density': putFloat(p + 72, x, 'ForceField.density'); break;
        case 'drag': putFloat(p + 76, x, 'ForceField.drag'); break;
        case 'skinFriction': putFloat(p + 80, x, 'ForceField.skinFriction'); break;
        case 'addedMass': putFloat(p + 84, x, 'ForceField.addedMass'); break;
        case 'waveDamping': putFloat(p + 88, x, 'ForceField.waveDamping'); break;
        default: unknown('ForceField', key, ['kind', 'direction', 'center', 'strength', 'exponent', 'isForce', 'halfExtents', 'density', 'drag', 'skinFriction', 'addedMass', 'waveDamping']);
        }
    }
}

export function getForceField(p) {
    return {
        kind: FORCE_FIELD_KIND[getInt(p + 4)],
        direction: getVec3(p + 8),
        center: getPosition(p + 24),
        strength: getFloat(p + 48),
        exponent: getFloat(p + 52),
        isForce: getBool(p + 56),
        halfExtents: getVec3(p + 60),
        density: getFloat(p + 72),
        drag: getFloat(p + 76),
        skinFriction: getFloat(p + 80),
        addedMass: getFloat(p + 84),
        waveDamping: getFloat(p + 88),
    };
}

export function getStageTimes(p) {
    return {
        broadPhase: getDouble(p),
        narrowPhase: getDouble(p + 8),
        islands: getDouble(p + 16),
        prepare: getDouble(p + 24),
        solve: getDouble(p + 32),
        finalize: getDouble(p + 40),
        total: getDouble(p + 48),
    };
}

export function getStatistics(p) {
    return {
        steps: getU64(p + 8),
        time: getDouble(p + 16),
        bodies: getSize(p + 24),
        dynamicBodies: getSize(p + 28),
        awakeBodies: getSize(p + 32),
        shapes: getSize(p + 36),
        candidatePairs: getSize(p + 40),
        testedPairs: getSize(p + 44),
        contacts: getSize(p + 48),
        contactPoints: getSize(p + 52),
        islands: getSize(p + 56),
        sleepingIslands: getSize(p + 60),
        colors: getSize(p + 64),
        overflowContacts: getSize(p + 68),
        clampedSpeeds: getU64(p + 72),
        maxSubsteps: getInt(p + 80),
        maxPenetration: getDouble(p + 88),
        sweptPairs: getSize(p + 96),
        impacts: getSize(p + 100),
        stoppedBodies: getSize(p + 104),
        times: getStageTimes(p + 112),
    };
}

export function getSnapshotSizes(p) {
    return {
        bodies: getSize(p),
        contacts: getSize(p + 4),
        joints: getSize(p + 8),
        broadPhase: getSize(p + 12),
        other: getSize(p + 16),
        definitions: getSize(p + 20),
    };
}

export const SHAPE_KINDS = ['sphere', 'box', 'plane', 'capsule', 'cylinder', 'hull', 'mesh', 'heightField'];

// An object whose `kind` says what it is; the other members are those of that kind.
export function putShape(p, value, where) {
    const { kind, ...members } = objectOf(value, where);
    const number = indexOf(SHAPE_KINDS, kind, where + '.kind');
    M._cairn_default_shape(p, number);
    switch (number) {
    case 0: return putSphere(p + 4, members, where);
    case 1: return putBox(p + 4, members, where);
    case 2: return putPlane(p + 4, members, where);
    case 3: return putCapsule(p + 4, members, where);
    case 4: return putCylinder(p + 4, members, where);
    case 5: return putHull(p + 4, members, where);
    case 6: return putMesh(p + 4, members, where);
    case 7: return putHeightField(p + 4, members, where);
    }
}

export function getShape(p) {
    switch (getInt(p)) {
    case 0: return { kind: 'sphere', ...getSphere(p + 4) };
    case 1: return { kind: 'box', ...getBox(p + 4) };
    case 2: return { kind: 'plane', ...getPlane(p + 4) };
    case 3: return { kind: 'capsule', ...getCapsule(p + 4) };
    case 4: return { kind: 'cylinder', ...getCylinder(p + 4) };
    case 5: return { kind: 'hull', ...getHull(p + 4) };
    case 6: return { kind: 'mesh', ...getMesh(p + 4) };
    case 7: return { kind: 'heightField', ...getHeightField(p + 4) };
    }
}

export const JOINT_KINDS = ['fixed', 'ball', 'hinge', 'slider', 'cylindrical', 'universal', 'distance', 'wheel', 'servo', 'gear', 'rack', 'pulley', 'general'];

// An object whose `kind` says what it is; the other members are those of that kind.
export function putJoint(p, value, where) {
    const { kind, ...members } = objectOf(value, where);
    const number = indexOf(JOINT_KINDS, kind, where + '.kind');
    M._cairn_default_joint(p, number);
    switch (number) {
    case 0: return putFixedJoint(p + 8, members, where);
    case 1: return putBallJoint(p + 8, members, where);
    case 2: return putHingeJoint(p + 8, members, where);
    case 3: return putSliderJoint(p + 8, members, where);
    case 4: return putCylindricalJoint(p + 8, members, where);
    case 5: return putUniversalJoint(p + 8, members, where);
    case 6: return putDistanceJoint(p + 8, members, where);
    case 7: return putWheelJoint(p + 8, members, where);
    case 8: return putServoJoint(p + 8, members, where);
    case 9: return putGearJoint(p + 8, members, where);
    case 10: return putRackJoint(p + 8, members, where);
    case 11: return putPulleyJoint(p + 8, members, where);
    case 12: return putGeneralJoint(p + 8, members, where);
    }
}

export function getJoint(p) {
    switch (getInt(p)) {
    case 0: return { kind: 'fixed', ...getFixedJoint(p + 8) };
    case 1: return { kind: 'ball', ...getBallJoint(p + 8) };
    case 2: return { kind: 'hinge', ...getHingeJoint(p + 8) };
    case 3: return { kind: 'slider', ...getSliderJoint(p + 8) };
    case 4: return { kind: 'cylindrical', ...getCylindricalJoint(p + 8) };
    case 5: return { kind: 'universal', ...getUniversalJoint(p + 8) };
    case 6: return { kind: 'distance', ...getDistanceJoint(p + 8) };
    case 7: return { kind: 'wheel', ...getWheelJoint(p + 8) };
    case 8: return { kind: 'servo', ...getServoJoint(p + 8) };
    case 9: return { kind: 'gear', ...getGearJoint(p + 8) };
    case 10: return { kind: 'rack', ...getRackJoint(p + 8) };
    case 11: return { kind: 'pulley', ...getPulleyJoint(p + 8) };
    case 12: return { kind: 'general', ...getGeneralJoint(p + 8) };
    }
}

// Of what lists by hand are made, and of definitions.
export const MATERIAL_BYTES = 28;
export const JOINT_SPRING_BYTES = 12;
export const JOINT_LIMIT_BYTES = 32;
export const JOINT_DRIVE_BYTES = 36;
export const JOINT_DEF_BYTES = 664;
export const JOINT_BYTES = 520;
export const BODY_DEF_BYTES = 160;
export const WORLD_DEF_BYTES = 60;
export const SNAPSHOT_SIZES_BYTES = 24;
export const BODY_ARRAYS_BYTES = 36;
export const BODY_ARRAYS_OFFSETS = { positions: 4, rotations: 12, linearVelocities: 20, angularVelocities: 28 };
