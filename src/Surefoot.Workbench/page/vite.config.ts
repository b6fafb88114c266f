import { defineConfig } from "vite";

// `npm run dev` serves the page with hot reload and forwards the rest to a workbench that is already running.
const workbench = "127.0.0.1:5150";

export default defineConfig({
  build: {
    outDir: "../wwwroot",
    emptyOutDir: true,
    chunkSizeWarningLimit: 1500,
  },
  server: {
    proxy: {
      "/ws": { target: `ws://${workbench}`, ws: true },
      "/terrain": `http://${workbench}`,
      "/shapes": `http://${workbench}`,
      "/places.json": `http://${workbench}`,
      "/stats.json": `http://${workbench}`,
    },
  },
});
