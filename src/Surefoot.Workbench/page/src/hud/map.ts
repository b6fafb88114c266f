// A small map from above: the ground, buildings or rooms, the way of the last walk, the player and the others. North is up.

import type { Vec3 } from "../net/wire";
import type { Surroundings } from "../things/worldView";
import { element, say } from "./elements";

/** Metres across that the map may show: what fits the way is chosen. */
const widths = [48, 96, 192, 384, 768, 1536];

/** The ground is painted in so many dots across, anew when the map has moved by so many of them. */
const dots = 96;
const repaintAfter = 4;

/** A level of rooms, metres from the feet. */
const levelBelow = 2.5;
const levelAbove = 3;

export interface Seen {
  surroundings: Surroundings;
  /** Feet of the player, global metres, and its heading, radians counter-clockwise from north. */
  player: Vec3;
  yaw: number;
  others: readonly Vec3[];
  path: readonly Vec3[];
  metres: number;
  seconds: number;
}

export class WalkMap {
  private readonly canvas = element<HTMLCanvasElement>("map-view");
  private readonly way = element("map-way");
  private readonly scale = element("map-scale");
  private readonly brush = this.canvas.getContext("2d") as CanvasRenderingContext2D;
  private readonly ground = document.createElement("canvas");
  private painted = { x: Number.NaN, y: 0, across: 0, at: 0 };
  private across = widths[0];

  /** Metres from the western rim to the eastern one. */
  get metresAcross(): number {
    return this.across;
  }

  /** Can the map be seen: is it neither folded nor put away? */
  get shown(): boolean {
    return this.canvas.checkVisibility();
  }

  draw(seen: Seen, now: number): void {
    const width = Math.round(this.canvas.clientWidth * Math.min(devicePixelRatio, 2));
    const height = Math.round(this.canvas.clientHeight * Math.min(devicePixelRatio, 2));
    if (width === 0 || height === 0) return;
    if (this.canvas.width !== width || this.canvas.height !== height) [this.canvas.width, this.canvas.height] = [width, height];
    this.across = this.widthFor(seen, height / width);
    const { brush } = this;
    const perMetre = width / this.across;
    const x = (east: number): number => width / 2 + (east - seen.player.x) * perMetre;
    const y = (north: number): number => height / 2 - (north - seen.player.y) * perMetre;
    brush.clearRect(0, 0, width, height);
    this.drawGround(seen, now, x, y, perMetre);
    this.drawWalls(seen, x, y, perMetre);
    this.drawPath(seen.path, x, y, width);
    for (const other of seen.others) dot(brush, x(other.x), y(other.y), width / 70, "#7fd0ff");
    arrow(brush, width / 2, height / 2, width / 34, -seen.yaw);
    letter(brush, "N", width * 0.95, width * 0.05, width / 16);
    this.write(seen);
  }

  /** The least width in which the whole way can be seen around the player. */
  private widthFor({ path, player }: Seen, shape: number): number {
    let reach = 0;
    for (const point of path) reach = Math.max(reach, Math.abs(point.x - player.x), Math.abs(point.y - player.y) / shape);
    return widths.find((one) => reach < one * 0.46) ?? widths[widths.length - 1];
  }

  private drawGround(seen: Seen, now: number, x: (east: number) => number, y: (north: number) => number, perMetre: number): void {
    const { across, painted } = this;
    const moved = Math.max(Math.abs(seen.player.x - painted.x), Math.abs(seen.player.y - painted.y));
    const stale = !(moved < (repaintAfter * across) / dots) || painted.across !== across || now - painted.at > 2;
    // Painted wider than the map, so that it can move before it is painted anew.
    const side = across * 1.25;
    if (stale) {
      this.paintGround(seen, side);
      this.painted = { x: seen.player.x, y: seen.player.y, across, at: now };
    }
    this.brush.drawImage(this.ground, x(this.painted.x - side / 2), y(this.painted.y + side / 2), side * perMetre, side * perMetre);
  }

  private paintGround({ surroundings, player }: Seen, side: number): void {
    this.ground.width = this.ground.height = dots;
    const paint = this.ground.getContext("2d") as CanvasRenderingContext2D;
    const picture = paint.createImageData(dots, dots);
    for (let row = 0; row < dots; row++) {
      for (let column = 0; column < dots; column++) {
        const east = player.x + ((column + 0.5) / dots - 0.5) * side;
        const north = player.y - ((row + 0.5) / dots - 0.5) * side;
        const color = surroundings.colorAt(east, north);
        if (color) picture.data.set([...color, 255], 4 * (row * dots + column));
      }
    }
    paint.putImageData(picture, 0, 0);
  }

  private drawWalls({ surroundings, player }: Seen, x: (east: number) => number, y: (north: number) => number, perMetre: number): void {
    const { brush } = this;
    brush.lineWidth = Math.max(1, perMetre * 0.25);
    brush.strokeStyle = "rgb(20 14 10 / 90%)";
    brush.fillStyle = "rgb(196 172 132 / 90%)";
    for (const { west, south, east, north, low, high } of surroundings.walls) {
      if (low > player.z + levelAbove || high < player.z - levelBelow) continue;
      const box = [x(west), y(north), (east - west) * perMetre, (north - south) * perMetre] as const;
      brush.fillRect(...box);
      brush.strokeRect(...box);
    }
  }

  private drawPath(path: readonly Vec3[], x: (east: number) => number, y: (north: number) => number, width: number): void {
    const [first, ...rest] = path;
    if (!first) return;
    const { brush } = this;
    brush.beginPath();
    brush.moveTo(x(first.x), y(first.y));
    for (const point of rest) brush.lineTo(x(point.x), y(point.y));
    brush.lineJoin = brush.lineCap = "round";
    for (const [color, share] of [
      ["rgb(10 15 20 / 80%)", 60],
      ["#ffc861", 105],
    ] as const) {
      brush.strokeStyle = color;
      brush.lineWidth = Math.max(width / share, 2);
      brush.stroke();
    }
    dot(brush, x(first.x), y(first.y), width / 60, "#ffffff");
  }

  private write({ metres, seconds }: Seen): void {
    say(this.way, `${metres.toFixed(1)} m in ${seconds.toFixed(1)} s`);
    say(this.scale, `${this.across} m across`);
    const label = `Map from above, north up, ${this.across} metres across, with the way of the last walk: ${Math.round(metres)} metres`;
    if (this.canvas.getAttribute("aria-label") !== label) this.canvas.setAttribute("aria-label", label);
  }
}

function dot(brush: CanvasRenderingContext2D, x: number, y: number, radius: number, color: string): void {
  brush.beginPath();
  brush.arc(x, y, radius, 0, 2 * Math.PI);
  brush.fillStyle = color;
  brush.fill();
  brush.lineWidth = radius / 3;
  brush.strokeStyle = "#10202e";
  brush.stroke();
}

function letter(brush: CanvasRenderingContext2D, text: string, x: number, y: number, size: number): void {
  brush.font = `600 ${size}px system-ui, sans-serif`;
  brush.textAlign = "center";
  brush.textBaseline = "middle";
  brush.lineJoin = "round";
  brush.lineWidth = size / 4;
  brush.strokeStyle = "#10202e";
  brush.strokeText(text, x, y);
  brush.fillStyle = "#ffffff";
  brush.fillText(text, x, y);
}

/** @param turn clockwise from up, radians */
function arrow(brush: CanvasRenderingContext2D, x: number, y: number, size: number, turn: number): void {
  brush.save();
  brush.translate(x, y);
  brush.rotate(turn);
  brush.beginPath();
  brush.moveTo(0, -size);
  brush.lineTo(size * 0.65, size * 0.8);
  brush.lineTo(0, size * 0.4);
  brush.lineTo(-size * 0.65, size * 0.8);
  brush.closePath();
  brush.fillStyle = "#ffffff";
  brush.strokeStyle = "#10202e";
  brush.lineWidth = size / 5;
  brush.fill();
  brush.stroke();
  brush.restore();
}
