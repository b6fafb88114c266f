// A click on the world that is no drag.

/** A pointer that strays so far while it is down drags, CSS pixels. */
const still = 6;

export class Pick {
  private downAt = { x: 0, y: 0 };

  /**
   * @param surface the world
   * @param onPick where it was clicked, as shares of the surface from the left and the top
   */
  constructor(surface: HTMLElement, onPick: (x: number, y: number) => void) {
    surface.addEventListener("pointerdown", ({ clientX, clientY }) => {
      this.downAt = { x: clientX, y: clientY };
    });
    surface.addEventListener("click", ({ clientX, clientY }) => {
      if (Math.hypot(clientX - this.downAt.x, clientY - this.downAt.y) > still) return;
      const box = surface.getBoundingClientRect();
      onPick((clientX - box.left) / box.width, (clientY - box.top) / box.height);
    });
  }
}
