// Sky dome, sun and fog: one colour at the horizon for all three, so that the land fades into the sky.

import * as THREE from "three";

/** What lies beyond the lantern's light. */
const darkness = new THREE.Color(0x0a0b0d);

/** Metres over the feet. */
const lanternHeight = 1.9;

export const horizonColor = new THREE.Color(0xc9dcea);
export const zenithColor = new THREE.Color(0x3f7fc4);
export const sunDirection = new THREE.Vector3(-0.55, -0.42, 0.62).normalize();

const vertex = /* glsl */ `
  varying vec3 vDirection;
  void main() {
    vDirection = position;
    vec4 at = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_Position = at.xyww;
  }
`;

const fragment = /* glsl */ `
  uniform vec3 uHorizon;
  uniform vec3 uZenith;
  uniform vec3 uSun;
  uniform float uTime;
  uniform sampler2D uNoise;
  varying vec3 vDirection;

  void main() {
    vec3 d = normalize(vDirection);
    float up = max(d.z, 0.0);
    vec3 color = mix(uHorizon, uZenith, pow(smoothstep(0.0, 0.75, up), 0.62));
    float toSun = max(dot(d, uSun), 0.0);
    color += vec3(1.0, 0.82, 0.55) * (0.16 * pow(toSun, 6.0) + 0.35 * pow(toSun, 90.0));
    color += vec3(1.0, 0.95, 0.85) * smoothstep(0.9993, 0.9997, toSun) * 2.0;
    if (d.z > 0.02) {
      vec2 p = d.xy / (d.z + 0.12) * 0.13 + uTime * vec2(0.0005, 0.0003);
      float cover = smoothstep(0.52, 0.80, texture2D(uNoise, p).x) * smoothstep(0.02, 0.22, d.z);
      vec3 cloud = mix(vec3(0.80, 0.84, 0.90), vec3(1.0, 0.99, 0.97), smoothstep(0.85, 0.45, texture2D(uNoise, p + 0.012 * uSun.xy).x));
      color = mix(color, cloud, 0.85 * cover);
    }
    gl_FragColor = vec4(color, 1.0);
    #include <colorspace_fragment>
  }
`;

const haze = 0.00195;
const gloom = 0.028;

export class Sky {
  readonly mesh: THREE.Mesh;
  readonly fog = new THREE.FogExp2(horizonColor, haze);
  private readonly time = { value: 0 };

  constructor(noise: THREE.Texture) {
    const material = new THREE.ShaderMaterial({
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: {
        uHorizon: { value: horizonColor },
        uZenith: { value: zenithColor },
        uSun: { value: sunDirection },
        uTime: this.time,
        uNoise: { value: noise },
      },
      side: THREE.BackSide,
      depthWrite: false,
      fog: false,
    });
    this.mesh = new THREE.Mesh(new THREE.SphereGeometry(100, 32, 20), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
  }

  /**
   * Under the ground there is darkness instead.
   * @param dark 0 outdoors, 1 in the depth
   * @param seen there is a sky to be seen
   */
  darken(dark: number, seen: boolean): void {
    this.mesh.visible = seen;
    this.fog.color.lerpColors(horizonColor, darkness, dark);
    this.fog.density = haze + (gloom - haze) * dark;
  }

  update(camera: THREE.Vector3, seconds: number): void {
    this.mesh.position.copy(camera);
    this.time.value = seconds;
  }
}

const day = { sky: new THREE.Color(0xbdd8f2), ground: new THREE.Color(0x6d6a4c), strength: 1.25, sun: 2.6, lantern: 0 };
const cave = { sky: new THREE.Color(0x8a93a6), ground: new THREE.Color(0x6b5f4f), strength: 0.65, sun: 0, lantern: 6.5 };

/** Sun and sky light; the sun's shadow follows a point. Where neither reaches, a lantern does. */
export class Lights {
  readonly group = new THREE.Group();
  readonly sun = new THREE.DirectionalLight(0xfff0d6, day.sun);
  private readonly sky = new THREE.HemisphereLight(day.sky, day.ground, day.strength);
  private readonly lantern = new THREE.PointLight(0xffd9a8, 0, 40, 1);

  constructor() {
    this.sky.position.set(0, 0, 1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.bias = -0.0008;
    this.sun.shadow.normalBias = 0.03;
    const view = this.sun.shadow.camera;
    view.left = view.bottom = -14;
    view.right = view.top = 14;
    view.near = 1;
    view.far = 160;
    this.group.add(this.sky, this.sun, this.sun.target, this.lantern);
  }

  follow(point: THREE.Vector3): void {
    this.sun.target.position.copy(point);
    this.sun.position.copy(point).addScaledVector(sunDirection, 80);
  }

  /** The lantern hangs over the way from the eye to the player. */
  hang(eye: THREE.Vector3): void {
    this.lantern.position.lerpVectors(eye, this.sun.target.position, 0.35);
    this.lantern.position.z = Math.max(this.lantern.position.z, this.sun.target.position.z + lanternHeight);
  }

  /**
   * Under the ground neither sun nor sky shine. The lights stay in the scene: their number is part of every shader.
   * @param dark 0 outdoors, 1 in the depth
   */
  darken(dark: number): void {
    this.sky.color.lerpColors(day.sky, cave.sky, dark);
    this.sky.groundColor.lerpColors(day.ground, cave.ground, dark);
    this.sky.intensity = day.strength + (cave.strength - day.strength) * dark;
    this.sun.intensity = day.sun + (cave.sun - day.sun) * dark;
    this.lantern.intensity = day.lantern + (cave.lantern - day.lantern) * dark;
  }
}
