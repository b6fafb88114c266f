// The renderer, and how much it may ask of the machine.

import * as THREE from "three";
import { FollowCamera } from "./camera";
import { Grass } from "./grass";
import { makeNoiseTexture } from "./noise";
import { Lights, Sky } from "./sky";

const slowFrame = 1 / 40;

export class Stage {
  readonly scene = new THREE.Scene();
  readonly noise = makeNoiseTexture();
  readonly sky = new Sky(this.noise);
  readonly lights = new Lights();
  readonly grass = new Grass();
  readonly view: FollowCamera;
  private readonly renderer: THREE.WebGLRenderer;
  private ratio = Math.min(devicePixelRatio, 2);
  private average = 1 / 60;
  private settled = 0;
  private grassAffordable = true;

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: devicePixelRatio < 2, powerPreference: "high-performance" });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = THREE.NoToneMapping;
    this.view = new FollowCamera(canvas);
    this.scene.fog = this.sky.fog;
    this.scene.add(this.sky.mesh, this.lights.group, this.grass.mesh);
    addEventListener("resize", () => this.resize());
    this.resize();
  }

  /** Smoothed time of a frame, seconds. */
  get frameTime(): number {
    return this.average;
  }

  /** The browser has taken the graphics card away; it may give it back. */
  get isDark(): boolean {
    return this.renderer.getContext().isContextLost();
  }

  /** Grass where one is outdoors and the machine is quick enough. */
  showGrass(outdoors: boolean): void {
    this.grass.mesh.visible = outdoors && this.grassAffordable;
  }

  render(dt: number): void {
    this.renderer.render(this.scene, this.view.camera);
    this.adapt(dt);
  }

  /** In how many pixels of a small picture of the view an object is seen. */
  pixelsOf(object: THREE.Object3D): number {
    const width = 480;
    const height = 270;
    const target = new THREE.WebGLRenderTarget(width, height);
    const shadows = this.renderer.shadowMap.autoUpdate;
    // The object's shadow stays: it is not the object.
    this.renderer.shadowMap.autoUpdate = false;
    const picture = (): Uint8Array => {
      const pixels = new Uint8Array(width * height * 4);
      this.renderer.setRenderTarget(target);
      this.renderer.render(this.scene, this.view.camera);
      this.renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
      return pixels;
    };
    const present = picture();
    const { visible } = object;
    object.visible = false;
    const without = picture();
    object.visible = visible;
    this.renderer.setRenderTarget(null);
    this.renderer.shadowMap.autoUpdate = shadows;
    target.dispose();
    let seen = 0;
    for (let i = 0; i < present.length; i += 4)
      if (present[i] !== without[i] || present[i + 1] !== without[i + 1] || present[i + 2] !== without[i + 2]) seen++;
    return seen;
  }

  /** A machine that cannot draw 40 frames a second gives up frosted glass, then grass, sharpness and shadows: motion comes first. */
  private adapt(dt: number): void {
    if (dt === 0 || dt > 0.5) return;
    this.average += (dt - this.average) * 0.05;
    if (++this.settled < 60 || this.average < slowFrame) return;
    this.settled = 0;
    if (!document.body.classList.contains("plain")) {
      document.body.classList.add("plain");
    } else if (this.grassAffordable) {
      this.grassAffordable = false;
    } else if (this.ratio > 0.5) {
      this.ratio = Math.max(0.5, this.ratio * 0.7);
      this.resize();
    } else if (this.lights.sun.castShadow) {
      this.lights.sun.castShadow = false;
    }
  }

  private resize(): void {
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(innerWidth, innerHeight, false);
    this.view.resize(innerWidth, innerHeight);
  }
}
