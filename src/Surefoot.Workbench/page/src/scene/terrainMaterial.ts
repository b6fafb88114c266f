// The ground's material: terrain colours blended inside each cell, roads by retail's rule, water, and on demand the triangles.

import * as THREE from "three";

/** Shared by all blocks: one write changes them all. */
export interface TerrainUniforms {
  time: { value: number };
  triangles: { value: number };
  sun: { value: THREE.Vector3 };
  skyColor: { value: THREE.Color };
  horizon: { value: THREE.Color };
  zenith: { value: THREE.Color };
  noise: { value: THREE.Texture };
}

const varyings = /* glsl */ `
  varying vec3 vGround;
  varying vec2 vCell;
  varying vec3 vEdge;
  varying vec3 vSmooth;
  varying vec4 vWater;
  varying vec3 vC00;
  varying vec3 vC01;
  varying vec3 vC10;
  varying vec3 vC11;
  flat varying vec3 vFace;
  flat varying float vRoad;
  flat varying float vCut;
`;

const vertexHead = /* glsl */ `
  attribute vec3 face;
  attribute vec2 cell;
  attribute vec3 edge;
  attribute vec2 code;
  attribute vec4 water;
  attribute vec3 c00;
  attribute vec3 c01;
  attribute vec3 c10;
  attribute vec3 c11;
  ${varyings}
`;

const vertexBody = /* glsl */ `
  vGround = (modelMatrix * vec4(position, 1.0)).xyz;
  vCell = cell;
  vEdge = edge;
  vSmooth = normal;
  vFace = face;
  vRoad = code.x;
  vCut = code.y;
  vWater = water;
  vC00 = c00;
  vC01 = c01;
  vC10 = c10;
  vC11 = c11;
`;

const fragmentHead = /* glsl */ `
  uniform float uTime;
  uniform float uTriangles;
  uniform vec3 uSun;
  uniform vec3 uSkyColor;
  uniform sampler2D uNoise;
  uniform vec3 uHorizon;
  uniform vec3 uZenith;
  ${varyings}
  float wetness = 0.0;
  float shoreFoam = 0.0;

  // Metres inside the road's edge (negative outside), from the corners with a road: bit 3 SW, 2 NW, 1 SE, 0 NE.
  float roadDepth(int corners, vec2 f) {
    if (corners == 0) return -24.0;
    if (corners == 15) return 5.0;
    if (corners == 14) return max(5.0 - f.x, 5.0 - f.y);
    if (corners == 13) return max(5.0 - f.x, f.y - 19.0);
    if (corners == 12) return 5.0 - f.x;
    if (corners == 11) return max(f.x - 19.0, 5.0 - f.y);
    if (corners == 10) return 5.0 - f.y;
    if (corners == 9) return 5.0 - abs(f.x - f.y);
    if (corners == 8) return 5.0 - (f.x + f.y);
    if (corners == 7) return max(f.x - 19.0, f.y - 19.0);
    if (corners == 6) return 5.0 - abs(f.x + f.y - 24.0);
    if (corners == 5) return f.y - 19.0;
    if (corners == 4) return 5.0 - (24.0 + f.x - f.y);
    if (corners == 3) return f.x - 19.0;
    if (corners == 2) return 5.0 - (24.0 - f.x + f.y);
    return 5.0 - (48.0 - f.x - f.y);
  }

  vec3 groundColor() {
    // Corner colours, blended with a wobble that fades towards the cell's border, where the neighbour takes over.
    vec2 f = clamp(vCell / 24.0, 0.0, 1.0);
    vec2 room = 4.0 * f * (1.0 - f);
    vec4 broad = texture2D(uNoise, vGround.xy / 190.0);
    vec4 fine = texture2D(uNoise, vGround.xy / 13.0);
    vec2 w = clamp(f + (broad.yz - 0.5) * 1.1 * room.x * room.y, 0.0, 1.0);
    w = mix(w, w * w * (3.0 - 2.0 * w), 0.6);
    vec3 color = mix(mix(vC00, vC10, w.x), mix(vC01, vC11, w.x), w.y);
    float wet = mix(mix(vWater.x, vWater.z, w.x), mix(vWater.y, vWater.w, w.x), w.y);
    wetness = smoothstep(0.46, 0.54, wet);
    shoreFoam = smoothstep(0.36, 0.5, wet) * (1.0 - smoothstep(0.52, 0.74, wet));

    float near = 1.0 - smoothstep(20.0, 90.0, length(vViewPosition));
    color *= 0.78 + 0.26 * broad.x + 0.18 * fine.x + 0.22 * near * (fine.y - 0.5);
    if (near > 0.5) color *= 1.0 + 0.5 * (near - 0.5) * (texture2D(uNoise, vGround.xy / 2.6).w - 0.5);

    float steep = smoothstep(0.80, 0.64, vSmooth.z + 0.08 * (fine.z - 0.5));
    // Ground too steep to stand on is bare, triangle by triangle, as physics sees it.
    steep = max(steep, smoothstep(0.69, 0.655, vFace.z));
    if (steep > 0.0) {
      float layers = texture2D(uNoise, vec2((vGround.x + vGround.y) / 60.0, vGround.z / 18.0)).w;
      color = mix(color, vec3(0.255, 0.235, 0.215) * (0.55 + 0.75 * layers), 0.85 * steep * (1.0 - wetness));
    }

    float depth = roadDepth(int(vRoad + 0.5), vCell) + 0.9 * (fine.x - 0.5);
    float road = smoothstep(-0.5, 0.5, depth);
    vec3 dirt = vec3(0.30, 0.225, 0.145) * (0.78 + 0.35 * fine.x + 0.25 * near * (fine.y - 0.5));
    color = mix(color, dirt, road * 0.92);
    color = mix(color, vec3(0.42, 0.36, 0.24), 0.7 * shoreFoam * (1.0 - wetness));
    return color;
  }
`;

const fragmentNormal = /* glsl */ `
  #include <normal_fragment_begin>
  normal = normalize(mix(normal, (viewMatrix * vec4(vFace, 0.0)).xyz, uTriangles));
`;

const fragmentColor = /* glsl */ `
  diffuseColor.rgb = groundColor();
  if (uTriangles > 0.0 && vFace.z < 0.66417414) {
    float stripe = step(0.5, fract((vGround.x + vGround.y + vGround.z) * 0.25));
    diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.62, 0.09, 0.06), uTriangles * (0.35 + 0.25 * stripe));
  }
`;

const fragmentLight = /* glsl */ `
  if (wetness > 0.0) {
    vec3 toEye = normalize(cameraPosition - vGround);
    vec2 p = vGround.xy / 26.0;
    float a = texture2D(uNoise, p + uTime * vec2(0.016, 0.009)).x;
    float b = texture2D(uNoise, p * 1.7 - uTime * vec2(0.012, 0.017)).y;
    float calm = 1.0 - 0.8 * smoothstep(30.0, 220.0, length(vViewPosition));
    vec3 ripple = normalize(vec3((a - 0.5) * 0.3 * calm, (b - 0.5) * 0.3 * calm, 1.0));
    float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(ripple, toEye), 0.0), 5.0);
    vec3 deep = outgoingLight * (0.72 + 0.4 * (a - 0.5));
    vec3 surface = mix(deep, uSkyColor, clamp(fresnel, 0.0, 0.85));
    float glint = pow(max(dot(reflect(-uSun, ripple), toEye), 0.0), 180.0);
    surface += vec3(1.0, 0.93, 0.78) * glint * 1.4;
    float foam = shoreFoam * smoothstep(0.45, 0.7, texture2D(uNoise, vGround.xy / 7.0 + uTime * vec2(0.03, -0.025)).z);
    surface = mix(surface, vec3(0.85, 0.92, 0.93), 0.75 * foam);
    outgoingLight = mix(outgoingLight, surface, wetness);
  }
  #include <opaque_fragment>
  if (uTriangles > 0.0) {
    vec3 width = fwidth(vEdge) * 1.1;
    vec3 line = 1.0 - smoothstep(vec3(0.0), width, vEdge);
    float fade = 1.0 - smoothstep(150.0, 420.0, length(vViewPosition));
    vec3 diagonal = vCut > 0.5 ? vec3(1.0, 0.72, 0.10) : vec3(0.25, 0.85, 1.0);
    gl_FragColor.rgb = mix(gl_FragColor.rgb, vec3(0.03, 0.04, 0.05), uTriangles * fade * 0.75 * max(line.x, line.y));
    gl_FragColor.rgb = mix(gl_FragColor.rgb, diagonal, uTriangles * fade * 0.95 * line.z);
  }
`;

// Far land fades into the sky behind it, which is bluer the higher one looks.
const fragmentFog = /* glsl */ `
  float far = 1.0 - exp(-fogDensity * fogDensity * vFogDepth * vFogDepth);
  float rise = max(normalize(vGround - cameraPosition).z, 0.0);
  vec3 behind = mix(uHorizon, uZenith, pow(smoothstep(0.0, 0.75, rise), 0.62));
  gl_FragColor.rgb = mix(gl_FragColor.rgb, linearToOutputTexel(vec4(behind, 1.0)).rgb, far);
`;

export function makeTerrainMaterial(uniforms: TerrainUniforms): THREE.MeshLambertMaterial {
  // Floors of rooms lie in the ground's own plane, and are the ones to be seen.
  const material = new THREE.MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 });
  material.onBeforeCompile = (shader) => {
    shader.uniforms.uTime = uniforms.time;
    shader.uniforms.uTriangles = uniforms.triangles;
    shader.uniforms.uSun = uniforms.sun;
    shader.uniforms.uSkyColor = uniforms.skyColor;
    shader.uniforms.uHorizon = uniforms.horizon;
    shader.uniforms.uZenith = uniforms.zenith;
    shader.uniforms.uNoise = uniforms.noise;
    shader.vertexShader = vertexHead + shader.vertexShader.replace("#include <begin_vertex>", `#include <begin_vertex>\n${vertexBody}`);
    shader.fragmentShader = shader.fragmentShader
      .replace("void main() {", `${fragmentHead}\nvoid main() {`)
      .replace("#include <color_fragment>", `#include <color_fragment>\n${fragmentColor}`)
      .replace("#include <normal_fragment_begin>", fragmentNormal)
      .replace("#include <opaque_fragment>", fragmentLight)
      .replace("#include <fog_fragment>", fragmentFog);
  };
  return material;
}
