// Puts the command for the last walk on the clipboard; where there is none to be had, shows it to be copied by hand.

import type { Walk } from "../net/wire";
import type { Notice } from "./notice";
import type { Toasts } from "./toasts";

/** Of a longer command only the beginning is shown, characters. */
const shownOf = 180;

/** A clipboard that does not answer is closed, milliseconds. */
const patienceFor = 1500;

export async function copyWalk({ command, leftOut }: Walk, toasts: Toasts, notice: Notice): Promise<void> {
  const without = leftOut === "" ? "" : ` It does without ${leftOut}.`;
  try {
    const patience = new Promise((_, reject) => setTimeout(reject, patienceFor));
    await Promise.race([navigator.clipboard.writeText(command), patience]);
    const shown = command.length > shownOf ? `${command.slice(0, shownOf)}…` : command;
    toasts.show(`Copied: ${shown}${without}`, "hint");
  } catch {
    notice.show(`The clipboard is closed to this page. Copy this: ${command}${without}`);
  }
}
