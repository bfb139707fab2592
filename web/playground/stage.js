// The picture: renderer, light and camera, and the bodies of the simulation in it.
import * as THREE from 'three';
import { OrbitControls } from 'three/OrbitControls';
import { WorldView } from 'cairn-physics/three';

export class Stage {
    constructor(canvas) {
        this.canvas = canvas;
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
        this.renderer.shadowMap.enabled = true;
        this.renderer.shadowMap.type = THREE.PCFShadowMap;
        this.scene = new THREE.Scene();
        this.scene.background = new THREE.Color(0x2a2f3a);
        this.eye = new THREE.PerspectiveCamera(45, 1, 0.05, 2000);
        this.controls = new OrbitControls(this.eye, canvas);
        this.sun = new THREE.DirectionalLight(0xffffff, 2.4);
        this.sun.castShadow = true;
        this.sun.shadow.mapSize.set(2048, 2048);
        this.sun.shadow.bias = -0.0005;
        this.scene.add(new THREE.HemisphereLight(0xdfe8ff, 0x4a4038, 1.3), this.sun, this.sun.target);
        this.view = null;
        addEventListener('resize', () => this.resize());
        this.resize();
    }

    /** Where the camera looks: its target and the direction to it. */
    get camera() {
        const { target } = this.controls;
        return { target, forward: target.clone().sub(this.eye.position).normalize() };
    }

    /** The ray from the camera through the place of a pointer. */
    ray(event) {
        const { left, top, width, height } = this.canvas.getBoundingClientRect();
        const at = new THREE.Vector2(
            (2 * (event.clientX - left)) / width - 1,
            1 - (2 * (event.clientY - top)) / height,
        );
        const caster = new THREE.Raycaster();
        caster.setFromCamera(at, this.eye);
        return caster.ray;
    }

    show({ world, camera }) {
        if (this.view) {
            this.scene.remove(this.view.group);
            this.view.dispose();
        }
        this.view = new WorldView(THREE, world);
        this.scene.add(this.view.group);
        const { position = [6, 4, 10], target = [0, 1, 0], vertical_fov_degrees: angle = 45 } = camera ?? {};
        this.eye.position.fromArray(position);
        this.eye.fov = angle;
        this.controls.target.fromArray(target);
        this.controls.update();
        const reach = Math.max(8, this.eye.position.distanceTo(this.controls.target) * 1.2);
        this.sun.target.position.copy(this.controls.target);
        this.sun.position.copy(this.controls.target).add(new THREE.Vector3(0.5, 1, 0.35).multiplyScalar(2 * reach));
        Object.assign(this.sun.shadow.camera, {
            left: -reach,
            right: reach,
            bottom: -reach,
            top: reach,
            near: 0.1,
            far: 5 * reach,
        });
        this.sun.shadow.camera.updateProjectionMatrix();
        this.resize();
    }

    rebuild() {
        this.view.rebuild();
    }

    draw() {
        this.controls.update();
        this.view.sync();
        this.renderer.render(this.scene, this.eye);
    }

    resize() {
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        this.renderer.setSize(innerWidth, innerHeight, false);
        this.eye.aspect = innerWidth / innerHeight;
        this.eye.updateProjectionMatrix();
    }
}
