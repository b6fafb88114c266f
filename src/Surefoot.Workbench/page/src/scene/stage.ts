// The renderer, and how much it may ask of the machine.

import * as THREE from "three";
import { isCalm } from "./calm";
import { FollowCamera } from "./camera";
import { Grass } from "./grass";
import { makeNoiseTexture } from "./noise";
import { Lights, Sky } from "./sky";
import type { Drawing } from "./webgl";

const slowFrame = 1 / 40;

/** Pixels drawn for one of the page's, in each direction. */
const leastRatio = 0.5;

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
  private dark = 0;

  constructor(canvas: HTMLCanvasElement, { software }: Drawing) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !software && devicePixelRatio < 2, powerPreference: "high-performance" });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = THREE.NoToneMapping;
    this.view = new FollowCamera(canvas);
    this.scene.fog = this.sky.fog;
    this.scene.add(this.sky.mesh, this.lights.group, this.grass.mesh);
    addEventListener("resize", () => this.resize());
    if (software) {
      this.noise.anisotropy = 1;
      while (this.giveUp());
    }
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

  /**
   * No land and no sky are seen from here; it gets dark at once, but not from one frame to the next.
   * @param dt seconds since the last frame
   */
  enclose(enclosed: boolean, dt: number): void {
    const wanted = enclosed ? 1 : 0;
    if (this.dark === wanted) return;
    this.dark += (wanted - this.dark) * (isCalm() ? 1 : 1 - Math.exp(-9 * dt));
    if (Math.abs(this.dark - wanted) < 0.005) this.dark = wanted;
    this.sky.darken(this.dark, !enclosed);
    this.lights.darken(this.dark);
    this.renderer.setClearColor(this.sky.fog.color);
    this.renderer.shadowMap.autoUpdate = this.dark < 1;
  }

  /** 1 in the depth, 0 outdoors. */
  get darkness(): number {
    return this.dark;
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
    const present = this.picture(480, 270);
    const { visible } = object;
    object.visible = false;
    const without = this.picture(480, 270);
    object.visible = visible;
    let seen = 0;
    for (let i = 0; i < present.length; i += 4)
      if (present[i] !== without[i] || present[i + 1] !== without[i + 1] || present[i + 2] !== without[i + 2]) seen++;
    return seen;
  }

  /**
   * The view in a small picture: red, green, blue and alpha of each pixel, 0 to 255, row by row from the bottom. Shadows are those of the
   * last frame.
   */
  picture(width: number, height: number): Uint8Array {
    const target = new THREE.WebGLRenderTarget(width, height, { colorSpace: THREE.SRGBColorSpace });
    const shadows = this.renderer.shadowMap.autoUpdate;
    this.renderer.shadowMap.autoUpdate = false;
    const pixels = new Uint8Array(width * height * 4);
    this.renderer.setRenderTarget(target);
    this.renderer.render(this.scene, this.view.camera);
    this.renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    this.renderer.setRenderTarget(null);
    this.renderer.shadowMap.autoUpdate = shadows;
    target.dispose();
    return pixels;
  }

  /** A machine that cannot draw 40 frames a second gives up one thing after the other: motion comes first. */
  private adapt(dt: number): void {
    if (dt === 0 || dt > 0.5) return;
    this.average += (dt - this.average) * 0.05;
    if (++this.settled < 60 || this.average < slowFrame) return;
    this.settled = 0;
    if (this.giveUp()) this.resize();
  }

  /** Frosted glass, then grass, sharpness and shadows; false when nothing is left to give up. */
  private giveUp(): boolean {
    if (!document.body.classList.contains("plain")) document.body.classList.add("plain");
    else if (this.grassAffordable) this.grassAffordable = false;
    else if (this.ratio > leastRatio) this.ratio = Math.max(leastRatio, this.ratio * 0.7);
    else if (this.lights.sun.castShadow) this.lights.sun.castShadow = false;
    else return false;
    return true;
  }

  private resize(): void {
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(innerWidth, innerHeight, false);
    this.view.resize(innerWidth, innerHeight);
  }
}
