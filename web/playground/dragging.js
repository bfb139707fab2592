// Dragging bodies with the mouse: a servo joint pulls the grabbed point to the mouse, in the plane that faces the
// camera.
import * as THREE from 'three';
import { springFromFrequency } from 'cairn-physics';

const HERTZ = 3,
    MOST_ACCELERATION = 300,
    SPIN_DAMPING = 4;

export class Dragging {
    constructor(stage, current) {
        this.stage = stage;
        this.current = current;
        this.held = null;
        const { canvas } = stage;
        // Registered before the camera's controls, which must not rotate the view while a body is dragged.
        canvas.addEventListener('pointerdown', (event) => event.button === 0 && this.begin(event), { capture: true });
        canvas.addEventListener('pointermove', (event) => this.move(event));
        for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => this.end());
    }

    begin(event) {
        const simulation = this.current();
        const ray = this.stage.ray(event);
        const { world } = simulation;
        const hit = world.castRay(ray.origin, ray.direction, 1000);
        if (!hit || world.body(hit.body).type !== 'dynamic') return;
        const body = world.body(hit.body);
        const { position, rotation } = body.transform;
        const point = new THREE.Vector3(hit.point.x, hit.point.y, hit.point.z);
        const local = point
            .clone()
            .sub(position)
            .applyQuaternion(new THREE.Quaternion(rotation.x, rotation.y, rotation.z, rotation.w).invert());
        const servo = {
            kind: 'servo',
            linear: springFromFrequency(HERTZ, 1),
            angular: { stiffness: 0, damping: SPIN_DAMPING, isAcceleration: true },
            maxForce: MOST_ACCELERATION * body.mass,
            position: [0, 0, 0],
        };
        const joint = world.createJoint({
            bodyB: body,
            frameA: { position: point },
            frameB: { position: local },
            enableCollision: true,
            joint: servo,
        });
        simulation.touched = true;
        const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(this.stage.camera.forward, point);
        this.held = { simulation, joint, servo, point, plane };
        this.stage.controls.enabled = false;
        this.stage.canvas.setPointerCapture(event.pointerId);
    }

    move(event) {
        if (!this.held) return;
        const { simulation, joint, servo, point, plane } = this.held;
        if (!simulation.world.jointIsValid(joint)) return this.end(); // the joint broke, or its body was removed
        const { origin, direction } = this.stage.ray(event);
        const target = new THREE.Ray(origin, direction).intersectPlane(plane, new THREE.Vector3());
        if (target) simulation.world.setJoint(joint, { ...servo, position: target.sub(point) });
    }

    end() {
        if (!this.held) return;
        const { simulation, joint } = this.held;
        this.held = null;
        this.stage.controls.enabled = true;
        if (simulation === this.current() && simulation.world.jointIsValid(joint)) simulation.world.destroyJoint(joint);
    }
}
