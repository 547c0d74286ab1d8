// Runs the command line built for WASI, with the repository as its whole disk: `node tests/web/wasi.mjs PROGRAM ARGUMENT…`.
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { WASI } from "node:wasi";

const [program, ...words] = process.argv.slice(2);
const root = resolve(import.meta.dirname, "../..");
const wasi = new WASI({ version: "preview1", args: ["resultant", "--data", "/", ...words], preopens: { "/": root } });
const { instance } = await WebAssembly.instantiate(readFileSync(program), wasi.getImportObject());
process.exitCode = wasi.start(instance);
