// Can this browser draw, and with what?

export function hasWebGL(): boolean {
  return ask(() => true) ?? false;
}

/** The processor draws, not a graphics card: in virtual machines, on remote desktops, where a driver is blocked. */
export function drawsInSoftware(): boolean {
  const name = ask((gl) => {
    const named = gl.getExtension("WEBGL_debug_renderer_info");
    return String(gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  });
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name ?? "");
}

function ask<T>(question: (gl: WebGL2RenderingContext) => T): T | null {
  try {
    const gl = document.createElement("canvas").getContext("webgl2");
    const answer = gl && question(gl);
    // Browsers allow few at a time: this one is given back.
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return answer;
  } catch {
    return null;
  }
}
