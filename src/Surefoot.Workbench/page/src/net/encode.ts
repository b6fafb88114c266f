// The frames that this page sends; `Wire/` in the server's source says the same. All numbers are little-endian.

import type { Network, Spot } from "./wire";

export function encodeInput(keys: number, sequence: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(6));
  view.setUint8(0, 0x01);
  view.setUint8(1, keys);
  view.setUint32(2, sequence, true);
  return view.buffer;
}

export function encodeSettings(runSkill: number, jumpSkill: number, burden: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(9));
  view.setUint8(0, 0x02);
  view.setUint16(1, runSkill, true);
  view.setUint16(3, jumpSkill, true);
  view.setUint32(5, burden, true);
  return view.buffer;
}

export function encodeGoto(place: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(3));
  view.setUint8(0, 0x03);
  view.setUint16(1, place, true);
  return view.buffer;
}

export function encodeUse(): ArrayBuffer {
  return new Uint8Array([0x04]).buffer;
}

/** @param right how far the pointer moved to the right, counts */
export function encodePointer(buttons: number, right: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(6));
  view.setUint8(0, 0x05);
  view.setUint8(1, buttons);
  view.setFloat32(2, right, true);
  return view.buffer;
}

export function encodeMouseTurning(on: boolean): ArrayBuffer {
  return new Uint8Array([0x06, on ? 1 : 0]).buffer;
}

export function encodeAutoRun(): ArrayBuffer {
  return new Uint8Array([0x07]).buffer;
}

export function encodeFocusLost(): ArrayBuffer {
  return new Uint8Array([0x08]).buffer;
}

export function encodeAskWalk(): ArrayBuffer {
  return new Uint8Array([0x0a]).buffer;
}

/** @param truth say also where the others are in truth */
export function encodeNetwork({ delay, jitter, loss }: Network, truth: boolean): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(8));
  view.setUint8(0, 0x0b);
  view.setUint16(1, delay, true);
  view.setUint16(3, jitter, true);
  view.setUint16(5, loss * 10, true);
  view.setUint8(7, truth ? 1 : 0);
  return view.buffer;
}

/** @param wish one of `Wish` */
export function encodeCreature(body: number, wish: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(6));
  view.setUint8(0, 0x0c);
  view.setUint32(1, body, true);
  view.setUint8(5, wish);
  return view.buffer;
}

/** Be at a spot; one without a height lies on the ground. */
export function encodePlaceAt(spot: Spot): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(21));
  view.setUint8(0, 0x09);
  view.setUint32(1, spot.cell, true);
  view.setFloat32(5, spot.x, true);
  view.setFloat32(9, spot.y, true);
  view.setFloat32(13, spot.z ?? Number.NaN, true);
  view.setFloat32(17, spot.yaw, true);
  return view.buffer;
}
