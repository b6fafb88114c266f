// Cards that fold to their titles. A page with little room has them folded, and opens one at a time.

import { element } from "./elements";

/** Too little room for all cards at once, or fingers that want some of it. */
const crowded = matchMedia("(width < 860px), (height < 540px), (pointer: coarse)");

interface Fold {
  title: HTMLElement;
  body: HTMLElement;
}

export class Folds {
  private readonly folds: Fold[];
  private readonly menu = element("menu");

  constructor() {
    this.folds = [...document.querySelectorAll<HTMLElement>(".fold")].map((card) => ({
      title: card.querySelector("h2 button") as HTMLElement,
      body: card.querySelector(".body") as HTMLElement,
    }));
    for (const fold of this.folds) {
      fold.title.addEventListener("click", () => this.open(fold, fold.title.getAttribute("aria-expanded") !== "true"));
      makeReachable(fold.body);
    }
    this.menu.addEventListener("click", () => {
      this.menu.setAttribute("aria-expanded", String(this.menu.getAttribute("aria-expanded") !== "true"));
    });
    crowded.addEventListener("change", () => this.arrange());
    this.arrange();
  }

  private arrange(): void {
    document.body.classList.toggle("compact", crowded.matches);
    for (const fold of this.folds) set(fold, !crowded.matches);
  }

  private open(fold: Fold, open: boolean): void {
    if (open && crowded.matches) for (const other of this.folds) set(other, false);
    set(fold, open);
  }
}

function set({ title, body }: Fold, open: boolean): void {
  title.setAttribute("aria-expanded", String(open));
  body.hidden = !open;
  reach(body);
}

/** What scrolls can be scrolled with the keyboard alone. */
export function makeReachable(body: HTMLElement): void {
  const sizes = new ResizeObserver(() => reach(body));
  for (const one of [body, ...body.children]) sizes.observe(one);
}

/** Looks whether it scrolls. */
export function reach(body: HTMLElement): void {
  if (body.scrollHeight > body.clientHeight + 1) body.tabIndex = 0;
  else body.removeAttribute("tabindex");
}
