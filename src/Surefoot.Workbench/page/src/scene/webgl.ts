// Can this browser draw, and with what?

/** What draws. */
export interface Drawing {
  /** The processor draws, not a graphics card: in virtual machines, on remote desktops, where a driver is blocked. */
  software: boolean;
}

/** Null without WebGL. */
export function findDrawing(): Drawing | null {
  try {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return null;
    const named = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    // Browsers allow few at a time: this one is given back.
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return { software: /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name) };
  } catch {
    return null;
  }
}
