// The players: one's own and the other pages'.

import * as THREE from "three";
import { type Drawn, PoseTimeline } from "../net/timeline";
import type { Others, OwnPose } from "../net/wire";
import { Figure } from "./figure";

export interface Player {
  timeline: PoseTimeline;
  figure: Figure;
  /** As drawn in the last frame; null until a pose has come. */
  drawn: Drawn | null;
}

export class Players {
  readonly group = new THREE.Group();
  readonly others = new Map<number, Player>();
  me: Player | null = null;

  /** A new life: everybody that was known is gone. */
  enter(id: number): void {
    for (const other of [...this.others.keys()]) this.leave(other);
    if (this.me) this.remove(this.me);
    this.me = this.add(id, null);
  }

  receivePose(pose: OwnPose): void {
    this.me?.timeline.push(pose);
  }

  /** Who is not listed is gone. */
  receiveOthers(frame: Others): void {
    const here = new Set(frame.players.map((player) => player.player));
    for (const id of [...this.others.keys()]) if (!here.has(id)) this.leave(id);
    for (const other of frame.players) {
      let player = this.others.get(other.player);
      if (!player) {
        player = this.add(other.player, `Player ${other.player}`);
        this.others.set(other.player, player);
      }
      player.timeline.push(other);
    }
  }

  /** Poses everybody for a moment of the server's clock. */
  update(time: number, origin: THREE.Vector3, seconds: number, dt: number): void {
    if (this.me) move(this.me, time, origin, seconds, dt);
    for (const player of this.others.values()) move(player, time, origin, seconds, dt);
  }

  private add(id: number, name: string | null): Player {
    const figure = new Figure(id, name);
    figure.group.visible = false;
    this.group.add(figure.group);
    return { timeline: new PoseTimeline(), figure, drawn: null };
  }

  private leave(id: number): void {
    const player = this.others.get(id);
    if (player) this.remove(player);
    this.others.delete(id);
  }

  private remove(player: Player): void {
    this.group.remove(player.figure.group);
    player.figure.dispose();
  }
}

function move(player: Player, time: number, origin: THREE.Vector3, seconds: number, dt: number): void {
  player.drawn = player.timeline.at(time);
  player.figure.group.visible = player.drawn !== null;
  if (player.drawn) player.figure.update(player.drawn, origin, seconds, dt);
}
