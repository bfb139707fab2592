// Rendering: the renderer, light and camera, and the bodies of the simulation.
import * as THREE from 'three';
import { OrbitControls } from 'three/OrbitControls';
import { WorldView } from 'cairn-physics/three';
import { halfHeight } from './cameras.js';

export class Stage {
    constructor(canvas) {
        this.canvas = canvas;
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
        this.renderer.shadowMap.enabled = true;
        this.renderer.shadowMap.type = THREE.PCFShadowMap;
        this.scene = new THREE.Scene();
        this.scene.background = new THREE.Color(0x2a2f3a);
        this.eyes = {
            perspective: new THREE.PerspectiveCamera(45, 1, 0.05, 2000),
            // Parallel rays also show what is behind the camera.
            parallel: new THREE.OrthographicCamera(-1, 1, 1, -1, -2000, 2000),
        };
        this.eye = this.eyes.perspective;
        this.controls = new OrbitControls(this.eye, canvas);
        this.sun = new THREE.DirectionalLight(0xffffff, 2.4);
        this.sun.castShadow = true;
        this.sun.shadow.mapSize.set(2048, 2048);
        this.sun.shadow.bias = -0.0005;
        this.scene.add(new THREE.HemisphereLight(0xdfe8ff, 0x4a4038, 1.3), this.sun, this.sun.target);
        this.view = null;
        this.halfHeight = 1; // half the picture's height for parallel rays, m
        addEventListener('resize', () => this.resize());
        this.resize();
    }

    /** The camera's target, and the direction to it. */
    get camera() {
        const { target } = this.controls;
        return { target, forward: target.clone().sub(this.eye.position).normalize() };
    }

    /** The ray from the camera through the position of a pointer. */
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
        const { position, target, vertical_fov_degrees: angle, orthographic } = camera;
        this.eye = this.controls.object = orthographic ? this.eyes.parallel : this.eyes.perspective;
        this.eye.position.fromArray(position);
        this.eye.zoom = 1;
        this.eyes.perspective.fov = angle;
        this.halfHeight = halfHeight(camera);
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
        const aspect = innerWidth / innerHeight;
        this.eyes.perspective.aspect = aspect;
        Object.assign(this.eyes.parallel, {
            left: -aspect * this.halfHeight,
            right: aspect * this.halfHeight,
            bottom: -this.halfHeight,
            top: this.halfHeight,
        });
        this.eye.updateProjectionMatrix();
    }
}
