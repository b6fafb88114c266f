// What a person reads whose browser cannot draw.

import { element } from "./elements";

export function explainNoWebGL(): void {
  const page = element("no-webgl");
  for (const other of document.body.children) if (other !== page) (other as HTMLElement).hidden = true;
  page.hidden = false;
  const again = page.querySelector("button") as HTMLElement;
  again.addEventListener("click", () => location.reload());
  again.focus({ preventScroll: true });
}
