import { describe, expect, it } from "vitest";
import {
  encodeAskWalk,
  encodeAutoRun,
  encodeCreature,
  encodeFocusLost,
  encodeGoto,
  encodeInput,
  encodeMouseTurning,
  encodeNetwork,
  encodePlaceAt,
  encodePointer,
  encodeSettings,
  encodeUse,
} from "./encode";
import { decode } from "./wire";
import samples from "./wire.samples.json";

const bytes = (hex: string): ArrayBuffer =>
  Uint8Array.from(hex.replaceAll(" ", "").match(/../g) ?? [], (pair) => parseInt(pair, 16)).buffer;
const vec = ([x, y, z]: number[]): object => ({ x, y, z });

describe("frames of the page", () => {
  it("are the sample's bytes", () => {
    expect(encodeInput(samples.input.keys, samples.input.sequence)).toEqual(bytes(samples.input.hex));
    expect(encodeSettings(samples.settings.runSkill, samples.settings.jumpSkill, samples.settings.burden)).toEqual(
      bytes(samples.settings.hex),
    );
    expect(encodeGoto(samples.goto.place)).toEqual(bytes(samples.goto.hex));
    expect(encodeUse()).toEqual(bytes(samples.use.hex));
    expect(encodePointer(samples.pointer.buttons, samples.pointer.right)).toEqual(bytes(samples.pointer.hex));
    expect(encodeMouseTurning(true)).toEqual(bytes(samples.mouseTurning.hex));
    expect(encodeAutoRun()).toEqual(bytes(samples.autoRun.hex));
    expect(encodeFocusLost()).toEqual(bytes(samples.focusLost.hex));
    expect(encodeNetwork(samples.network.network, samples.network.truth)).toEqual(bytes(samples.network.hex));
    expect(encodeCreature(samples.creature.body, samples.creature.wish)).toEqual(bytes(samples.creature.hex));
    expect(encodeAskWalk()).toEqual(bytes(samples.askWalk.hex));
    const { cell, position, yaw } = samples.placeAt;
    expect(encodePlaceAt({ cell, x: position[0], y: position[1], z: position[2], yaw })).toEqual(bytes(samples.placeAt.hex));
    expect(encodePlaceAt({ cell, x: position[0], y: position[1], z: null, yaw })).toEqual(bytes(samples.placeOnGround.hex));
  });
});

describe("frames of the server", () => {
  it("have the sample's values", () => {
    const { hex: welcomeHex, ...welcome } = samples.welcome;
    expect(decode(bytes(welcomeHex))).toEqual({ kind: "welcome", ...welcome });
    const { hex: poseHex, ...pose } = samples.pose;
    const vectors = { position: vec(pose.position), velocity: vec(pose.velocity), planeNormal: vec(pose.planeNormal) };
    expect(decode(bytes(poseHex))).toEqual({ kind: "pose", ...pose, ...vectors });
    const other = samples.others.player;
    const player = { ...other, time: samples.others.time, position: vec(other.position), velocity: vec(other.velocity) };
    expect(decode(bytes(samples.others.hex))).toEqual({ kind: "others", time: samples.others.time, players: [player] });
    const bodies = samples.bodies.bodies.map((one) => ({
      ...one,
      position: vec(one.position),
      velocity: vec(one.velocity),
      size: vec(one.size),
    }));
    expect(decode(bytes(samples.bodies.hex))).toEqual({ kind: "bodies", time: samples.bodies.time, bodies });
    const touches = samples.touches.touches.map((one) => ({ ...one, normal: vec(one.normal) }));
    expect(decode(bytes(samples.touches.hex))).toEqual({ kind: "touches", touches });
    const part = { ...samples.moving.part, position: vec(samples.moving.part.position) };
    expect(decode(bytes(samples.moving.hex))).toEqual({ kind: "moving", time: samples.moving.time, parts: [part] });
    const place = { ...samples.truth.place, position: vec(samples.truth.place.position) };
    expect(decode(bytes(samples.truth.hex))).toEqual({ kind: "truth", time: samples.truth.time, places: [place] });
    const { hex: walkHex, ...walk } = samples.walk;
    expect(decode(bytes(walkHex))).toEqual({ kind: "walk", ...walk });
    const { hex: sentenceHex, ...sentence } = samples.sentence;
    expect(decode(bytes(sentenceHex))).toEqual({ kind: "sentence", ...sentence });
    const { hex: eventHex, ...event } = samples.event;
    expect(decode(bytes(eventHex))).toEqual({ kind: "event", ...event });
  });

  it("are refused when their length is wrong", () => {
    for (const hex of [
      samples.welcome.hex,
      samples.pose.hex,
      samples.others.hex,
      samples.event.hex,
      samples.bodies.hex,
      samples.touches.hex,
      samples.moving.hex,
      samples.walk.hex,
      samples.sentence.hex,
      samples.truth.hex,
    ]) {
      const whole = bytes(hex);
      for (let length = 0; length < whole.byteLength; length++) expect(decode(whole.slice(0, length))).toBeNull();
    }
    expect(decode(bytes("7f 00"))).toBeNull();
  });
});
