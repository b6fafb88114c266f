// Sky dome, sun and fog: one colour at the horizon for all three, so that the land fades into the sky.

import * as THREE from "three";

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

export class Sky {
  readonly mesh: THREE.Mesh;
  readonly fog = new THREE.FogExp2(horizonColor, 0.00195);
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

  update(camera: THREE.Vector3, seconds: number): void {
    this.mesh.position.copy(camera);
    this.time.value = seconds;
  }
}

/** Sun and sky light; the sun's shadow follows a point. */
export class Lights {
  readonly group = new THREE.Group();
  readonly sun = new THREE.DirectionalLight(0xfff0d6, 2.6);

  constructor() {
    const sky = new THREE.HemisphereLight(0xbdd8f2, 0x6d6a4c, 1.25);
    sky.position.set(0, 0, 1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.bias = -0.0008;
    this.sun.shadow.normalBias = 0.03;
    const view = this.sun.shadow.camera;
    view.left = view.bottom = -14;
    view.right = view.top = 14;
    view.near = 1;
    view.far = 160;
    this.group.add(sky, this.sun, this.sun.target);
  }

  follow(point: THREE.Vector3): void {
    this.sun.target.position.copy(point);
    this.sun.position.copy(point).addScaledVector(sunDirection, 80);
  }
}
