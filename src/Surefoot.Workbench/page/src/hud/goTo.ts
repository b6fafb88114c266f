// The box that takes a place: its name, some words of what there is to try, or a cell and metres.

import { type Destination, type Place, readDestination, searchPlaces } from "../net/places";
import { formatSpot, looksLikeSpot } from "../net/spot";
import { element } from "./elements";

export class GoTo {
  private readonly box = element<HTMLInputElement>("goto-box");
  private readonly list = element("goto-list");
  private readonly error = element("goto-error");
  private places: readonly Place[] = [];
  private chosen = -1;

  /** @param go the person goes there */
  constructor(private readonly go: (destination: Exclude<Destination, { error: string }>) => void) {
    this.box.addEventListener("input", () => this.search());
    this.box.addEventListener("click", () => this.search());
    this.box.addEventListener("blur", () => this.close());
    this.box.addEventListener("keydown", (event) => this.key(event));
    // A press on the list leaves the keyboard in the box.
    this.list.addEventListener("mousedown", (event) => event.preventDefault());
    this.list.addEventListener("click", (event) => {
      const option = (event.target as HTMLElement).closest<HTMLElement>("[role=option]");
      if (option) this.pick(option);
    });
  }

  /** The places that the box knows, by the index that the server knows them by. */
  get listed(): readonly Place[] {
    return this.places;
  }

  offer(places: readonly Place[]): void {
    this.places = places;
  }

  focus(): void {
    this.box.focus();
    this.box.select();
    this.search();
  }

  private key(event: KeyboardEvent): void {
    const { children } = this.list;
    switch (event.key) {
      case "ArrowDown":
      case "ArrowUp":
        if (this.list.hidden) this.search();
        else this.choose((this.chosen + (event.key === "ArrowDown" ? 1 : -1) + children.length) % children.length);
        event.preventDefault();
        break;
      case "Enter":
        event.preventDefault();
        this.enter();
        break;
      case "Escape":
        if (this.list.hidden && this.error.hidden && this.box.value === "") break;
        event.preventDefault();
        this.box.value = "";
        this.close();
        break;
    }
  }

  private search(): void {
    this.error.hidden = true;
    const text = this.box.value;
    const found = looksLikeSpot(text) ? [] : searchPlaces(text, this.places);
    const spot = readDestination(text, this.places);
    const options = found.map((index) => optionOf(String(index), this.places[index].name, this.places[index].hint ?? ""));
    if ("spot" in spot) options.push(optionOf("spot", `Go to ${formatSpot(spot.spot).replaceAll(",", ", ")}`, ""));
    this.list.replaceChildren(...options);
    this.show(options.length > 0);
    this.choose(text.trim() !== "" && options.length > 0 ? 0 : -1);
  }

  private choose(index: number): void {
    this.chosen = index;
    for (const [i, option] of [...this.list.children].entries()) {
      option.id = `goto-option-${i}`;
      option.setAttribute("aria-selected", String(i === index));
    }
    const option = this.list.children[index];
    if (option) {
      this.box.setAttribute("aria-activedescendant", option.id);
      option.scrollIntoView({ block: "nearest" });
    } else {
      this.box.removeAttribute("aria-activedescendant");
    }
  }

  private enter(): void {
    const option = this.list.hidden ? undefined : (this.list.children[this.chosen] as HTMLElement | undefined);
    if (option) this.pick(option);
    else this.goAsWritten();
  }

  private pick({ dataset: { place } }: HTMLElement): void {
    if (place === "spot") this.goAsWritten();
    else this.leave({ place: Number(place) });
  }

  private goAsWritten(): void {
    const destination = readDestination(this.box.value, this.places);
    if (!("error" in destination)) {
      this.leave(destination);
      return;
    }
    this.close();
    this.error.textContent = `${destination.error[0].toUpperCase()}${destination.error.slice(1)}.`;
    this.error.hidden = false;
  }

  private leave(destination: Exclude<Destination, { error: string }>): void {
    this.box.value = "";
    this.close();
    this.go(destination);
  }

  private close(): void {
    this.show(false);
    this.choose(-1);
    this.error.hidden = true;
  }

  private show(open: boolean): void {
    this.list.hidden = !open;
    this.box.setAttribute("aria-expanded", String(open));
  }
}

function optionOf(place: string, name: string, hint: string): HTMLElement {
  const option = document.createElement("li");
  option.role = "option";
  option.dataset.place = place;
  const title = document.createElement("span");
  title.textContent = name;
  option.append(title);
  if (hint !== "") {
    const small = document.createElement("small");
    small.textContent = hint;
    option.append(small);
  }
  return option;
}
