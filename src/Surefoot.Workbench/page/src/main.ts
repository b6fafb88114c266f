// Plays where a picture can be drawn, and says why not where none can.

import "./hud/style/index.css";
import { explainNoWebGL } from "./hud/noWebGL";
import { play } from "./play";
import { findDrawing } from "./scene/webgl";

const drawing = findDrawing();
if (drawing) play(drawing);
else explainNoWebGL();
