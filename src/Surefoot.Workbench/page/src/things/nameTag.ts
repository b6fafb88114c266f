// A name that floats over another player's head, the same size on screen at any distance.

import * as THREE from "three";

export function makeNameTag(text: string): THREE.Sprite {
  const canvas = document.createElement("canvas");
  canvas.width = 256;
  canvas.height = 64;
  const draw = canvas.getContext("2d")!;
  draw.font = "600 30px system-ui, sans-serif";
  const width = Math.min(250, draw.measureText(text).width + 36);
  draw.fillStyle = "rgb(16 26 36 / 90%)";
  draw.beginPath();
  draw.roundRect((256 - width) / 2, 8, width, 48, 24);
  draw.fill();
  draw.fillStyle = "#eef3f7";
  draw.textAlign = "center";
  draw.textBaseline = "middle";
  draw.fillText(text, 128, 33);
  const map = new THREE.CanvasTexture(canvas);
  map.colorSpace = THREE.SRGBColorSpace;
  const tag = new THREE.Sprite(new THREE.SpriteMaterial({ map, sizeAttenuation: false, fog: false, depthTest: true, transparent: true }));
  tag.scale.set(0.14, 0.035, 1);
  tag.position.z = 2.15;
  tag.renderOrder = 2;
  return tag;
}

export function disposeNameTag(tag: THREE.Sprite): void {
  tag.material.map?.dispose();
  tag.material.dispose();
}
